using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint
{
    /// <summary>
    /// The renderers visible to a radar: enabled, of active objects on its layers and below its roots, of LOD 0, and
    /// not below its receiver.
    /// </summary>
    public sealed class VisibleRenderers
    {
        readonly HierarchyWalk _walk = new HierarchyWalk();

        /// <summary>The renderers in the order of the hierarchy; those below nested roots repeat.</summary>
        /// <param name="roots">Not null; empty: every loaded scene.</param>
        /// <param name="receiver">May be null.</param>
        public IEnumerable<Renderer> Find(LayerMask layers, IReadOnlyList<Transform> roots, Transform receiver)
        {
            var lowerDetail = LowerDetail();
            foreach (var renderer in _walk.Find(roots))
            {
                var owner = renderer.gameObject;
                if (!renderer.enabled || !owner.activeInHierarchy || (layers.value & (1 << owner.layer)) == 0
                    || lowerDetail.Contains(renderer))
                    continue;
                if (receiver == null || !renderer.transform.IsChildOf(receiver))
                    yield return renderer;
            }
        }

        static HashSet<Renderer> LowerDetail()
        {
            var first = new HashSet<Renderer>();
            var lower = new HashSet<Renderer>();
            foreach (var group in Object.FindObjectsByType<LODGroup>(FindObjectsInactive.Exclude,
                FindObjectsSortMode.None))
            {
                var lods = group.GetLODs();
                lower.UnionWith(lods.Skip(1).SelectMany(lod => lod.renderers));
                first.UnionWith(lods.Take(1).SelectMany(lod => lod.renderers));
            }
            lower.ExceptWith(first);
            return lower;
        }
    }

    /// <summary>
    /// Lists the renderers of active objects in the order of the Hierarchy window: scene by scene, parents before
    /// children, siblings in order.
    /// </summary>
    sealed class HierarchyWalk
    {
        readonly List<Renderer> _renderers = new List<Renderer>(), _below = new List<Renderer>();
        readonly List<GameObject> _sceneRoots = new List<GameObject>();

        /// <summary>
        /// The renderers at and below the roots, in their order; those of nested roots more than once.
        /// No roots: those of every loaded scene.
        /// </summary>
        public IReadOnlyList<Renderer> Find(IReadOnlyList<Transform> roots)
        {
            _renderers.Clear();
            if (roots.Count == 0)
                AddLoadedScenes();
            foreach (var root in roots)
            {
                root.GetComponentsInChildren(_below);
                _renderers.AddRange(_below);
            }
            return _renderers;
        }

        void AddLoadedScenes()
        {
            for (int i = 0; i < SceneManager.sceneCount; i++)
            {
                var scene = SceneManager.GetSceneAt(i);
                // In play mode a scene that is still loading already has objects with running scripts.
                if (!scene.isLoaded && !Application.isPlaying)
                    continue;
                scene.GetRootGameObjects(_sceneRoots);
                foreach (var root in _sceneRoots)
                    AddVisible(root);
            }
            if (Application.isPlaying)
                AddSurvivors();
        }

        // Objects that survive loading are in a separate scene, which is not listed: they come last.
        void AddSurvivors()
        {
            var roots = new HashSet<Transform>();
            foreach (var renderer in Object.FindObjectsByType<Renderer>(FindObjectsInactive.Exclude,
                FindObjectsSortMode.None))
                if (!IsListed(renderer.gameObject.scene))
                    roots.Add(renderer.transform.root);
            foreach (var root in roots.OrderBy(root => root.GetSiblingIndex()))
                AddVisible(root.gameObject);
        }

        static bool IsListed(Scene scene)
        {
            for (int i = 0; i < SceneManager.sceneCount; i++)
                if (SceneManager.GetSceneAt(i) == scene)
                    return true;
            return false;
        }

        // The editor's hidden objects are not part of the scene; the hidden tiles of a sea are.
        void AddVisible(GameObject root)
        {
            root.GetComponentsInChildren(_below);
            foreach (var renderer in _below)
                if ((renderer.gameObject.hideFlags & HideFlags.HideInHierarchy) == 0
                    || renderer.TryGetComponent<SeaTile>(out _))
                    _renderers.Add(renderer);
        }
    }
}
