using System;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>What a button mends; one step of Undo.</summary>
    sealed class Fix
    {
        readonly Action _mend;

        /// <param name="label">What the button says, and Undo.</param>
        /// <param name="mend">Makes its changes by <see cref="Change"/> and Undo.</param>
        public Fix(string label, Action mend) =>
            (Label, _mend) = (label, mend);

        public string Label { get; }

        /// <summary>Mends it. The scene counts as changed.</summary>
        public void Apply() => AsOneStep(Label, _mend);

        /// <summary>Does something that Undo takes back in one step.</summary>
        public static void AsOneStep(string name, Action work)
        {
            Undo.IncrementCurrentGroup();
            Undo.SetCurrentGroupName(name);
            int group = Undo.GetCurrentGroup();
            work();
            Undo.FlushUndoRecordObjects();
            Undo.CollapseUndoOperations(group);
        }

        /// <summary>
        /// Changes serialized fields so that Undo takes it back, and an instance of a prefab keeps it as an override.
        /// </summary>
        public static void Change<T>(T target, string name, Action<T> change) where T : Object
        {
            Undo.RecordObject(target, name);
            change(target);
            PrefabUtility.RecordPrefabInstancePropertyModifications(target);
        }
    }
}
