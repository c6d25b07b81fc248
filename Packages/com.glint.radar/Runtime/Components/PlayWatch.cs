using System;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Tells a component that runs in edit mode too when the scene begins to play. Where Play does not reload the scene
    /// (Project Settings, Editor), Unity does not send Start again to a script that had it in edit mode. Serializable, so
    /// that Unity keeps it when scripts are compiled during Play: the scene does not begin to play then.
    /// </summary>
    [Serializable]
    struct PlayWatch
    {
        bool _isPlaying;

        /// <summary>True once each time that the scene plays; ask in Start and in every Update.</summary>
        public bool Begins(Component component)
        {
            bool wasPlaying = _isPlaying;
            _isPlaying = Application.IsPlaying(component.gameObject);
            return _isPlaying && !wasPlaying;
        }

        /// <summary>Notes the end of Play, after which there may be no Update in edit mode; for OnEnable.</summary>
        public void Enable(Component component) => _isPlaying &= Application.IsPlaying(component.gameObject);
    }
}
