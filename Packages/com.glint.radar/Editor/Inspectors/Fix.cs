using System;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>A fix for a button; one step of Undo.</summary>
    sealed class Fix
    {
        readonly Action _mend;

        /// <param name="label">Label of the button and of Undo.</param>
        /// <param name="mend">Makes the changes, by <see cref="Change"/> and Undo.</param>
        public Fix(string label, Action mend) =>
            (Label, _mend) = (label, mend);

        public string Label { get; }

        /// <summary>Applies the fix and marks the scene as changed.</summary>
        public void Apply() => AsOneStep(Label, _mend);

        /// <summary>Does work that Undo reverts in one step.</summary>
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
        /// Changes serialized fields with Undo; in an instance of a prefab the change is an override.
        /// </summary>
        public static void Change<T>(T target, string name, Action<T> change) where T : Object
        {
            Undo.RecordObject(target, name);
            change(target);
            PrefabUtility.RecordPrefabInstancePropertyModifications(target);
        }
    }
}
