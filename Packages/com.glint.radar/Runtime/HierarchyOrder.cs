using System.Collections.Generic;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint
{
    /// <summary>Orders transforms as the Hierarchy window lists them: by scene, then parents before children, siblings in order.</summary>
    sealed class HierarchyOrder : IComparer<Transform>
    {
        public static readonly HierarchyOrder Instance = new HierarchyOrder();

        public int Compare(Transform a, Transform b)
        {
            if (a == b)
                return 0;
            int byScene = SceneIndex(a).CompareTo(SceneIndex(b));
            if (byScene != 0)
                return byScene;
            int depthA = Depth(a), depthB = Depth(b);
            var (atA, atB) = (Ancestor(a, depthA - depthB), Ancestor(b, depthB - depthA));
            if (atA == atB)
                return depthA.CompareTo(depthB);
            while (atA.parent != atB.parent)
                (atA, atB) = (atA.parent, atB.parent);
            return atA.GetSiblingIndex().CompareTo(atB.GetSiblingIndex());
        }

        // Objects that survive loading are in a scene of their own, which is not among the others: they come last.
        static int SceneIndex(Transform t)
        {
            int index = 0;
            while (index < SceneManager.sceneCount && SceneManager.GetSceneAt(index) != t.gameObject.scene)
                index++;
            return index;
        }

        static int Depth(Transform t)
        {
            int depth = 0;
            for (var parent = t.parent; parent != null; parent = parent.parent)
                depth++;
            return depth;
        }

        static Transform Ancestor(Transform t, int generations)
        {
            for (int i = 0; i < generations; i++)
                t = t.parent;
            return t;
        }
    }
}
