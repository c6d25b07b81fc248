using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Random changes of a scene between two poses; the same for a seed.</summary>
    sealed class RandomChanges
    {
        readonly SceneBuilder _scene;
        readonly System.Random _random;
        readonly Mesh[] _meshes;
        readonly List<Transform> _objects = new List<Transform>();

        public RandomChanges(SceneBuilder scene, System.Random random)
        {
            _scene = scene;
            _random = random;
            _meshes = Enumerable.Range(0, 4)
                .Select(i => SceneBuilder.Mesh(2 + i, 10 * i + random.Next(1, 9))).ToArray();
            for (int i = 0; i < 6; i++)
                Add();
        }

        /// <summary>The traced objects, in the order of the hierarchy.</summary>
        public IEnumerable<Transform> Active => _scene.Root.GetComponentsInChildren<MeshRenderer>()
            .Where(renderer => renderer.enabled).Select(renderer => renderer.transform);

        /// <summary>Makes one change and returns its description.</summary>
        public string Next(SceneGatherer gatherer)
        {
            if (_objects.Count == 0)
                return Add();
            var item = _objects[_random.Next(_objects.Count)];
            switch (_random.Next(12))
            {
                case 0:
                    return Add();
                case 1:
                    return Destroy(item);
                case 2:
                    return Hang(item, _objects[_random.Next(_objects.Count)]);
                case 3:
                    item.gameObject.SetActive(!item.gameObject.activeSelf);
                    return $"{item.name} activated or deactivated";
                case 4:
                    item.GetComponent<MeshRenderer>().enabled ^= true;
                    return $"renderer of {item.name} enabled or disabled";
                case 5:
                    item.GetComponent<MeshFilter>().sharedMesh = _meshes[_random.Next(_meshes.Length)];
                    return $"{item.name} has another mesh";
                case 6:
                    return Deform(_meshes[_random.Next(_meshes.Length)]);
                case 7:
                    // Sometimes flat, mirrored or stretched.
                    item.localScale = new Vector3(Number(2), _random.Next(4) == 0 ? 0 : 1, 1);
                    return $"{item.name} scaled";
                case 8:
                    gatherer.ExpectMotion(item);
                    return $"{item.name} is expected to move";
                case 9:
                    return "nothing";
                case 10:
                    item.localPosition = new Vector3(Number(5), Number(5), Number(5));
                    return $"{item.name} moved";
                default:
                    item.localRotation = Quaternion.Euler(Number(180), Number(180), 0);
                    return $"{item.name} turned";
            }
        }

        string Add()
        {
            var parent =
                _objects.Count > 0 && _random.Next(2) == 0 ? _objects[_random.Next(_objects.Count)] : _scene.Root;
            var added = _scene.Add($"Object {_random.Next(1000)}", _meshes[_random.Next(_meshes.Length)], parent);
            added.localPosition = new Vector3(Number(5), Number(5), Number(5));
            _objects.Add(added);
            return $"{added.name} added";
        }

        string Destroy(Transform item)
        {
            string what = $"{item.name} destroyed";
            Object.DestroyImmediate(item.gameObject);
            _objects.RemoveAll(other => other == null);
            return what;
        }

        string Hang(Transform item, Transform parent)
        {
            if (parent == item || parent.IsChildOf(item))
                parent = _scene.Root;
            item.SetParent(parent, false);
            return $"{item.name} below {parent.name}";
        }

        string Deform(Mesh mesh)
        {
            var vertices = mesh.vertices;
            vertices[_random.Next(vertices.Length)] += new Vector3(0, 0.1f, 0);
            mesh.vertices = vertices;
            return $"{mesh.name} deformed";
        }

        float Number(float max) => (float)(2 * _random.NextDouble() - 1) * max;
    }
}
