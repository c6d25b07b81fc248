using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>Objects that survive loading are in a separate scene, which is not among the loaded ones.</summary>
    public sealed class SurvivingObjectsTests
    {
        [UnityTest]
        public IEnumerator Gather_NoRoots_TakesObjectsThatSurviveLoadingLast()
        {
            var survivor = Cube("Survivor");
            var other = Cube("Other survivor");
            Object.DontDestroyOnLoad(survivor);
            Object.DontDestroyOnLoad(other);
            var inScene = Cube("In the scene");
            yield return null;
            try
            {
                var found = new HierarchyWalk().Find(new List<Transform>())
                    .Select(renderer => renderer.gameObject).ToList();
                Assert.That(found.GetRange(found.Count - 2, 2), Is.EqualTo(new[] { survivor, other }));
                Assert.That(found.Count(item => item == survivor), Is.EqualTo(1));
                Assert.That(found.Contains(inScene));

                inScene.SetActive(false);
                other.SetActive(false);
                found = new HierarchyWalk().Find(new List<Transform>())
                    .Select(renderer => renderer.gameObject).ToList();
                Assert.That(found.Contains(survivor));
                Assert.That(found.Contains(inScene) || found.Contains(other), Is.False, "inactive ones");
            }
            finally
            {
                foreach (var item in new[] { survivor, other, inScene })
                    Object.DestroyImmediate(item);
            }
        }

        static GameObject Cube(string name)
        {
            var cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.name = name;
            return cube;
        }
    }
}
