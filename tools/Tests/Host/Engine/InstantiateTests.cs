using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

public sealed class InstantiateTests : EngineFixture
{
    [Test]
    public void Clone_ReferencesInsideTheHierarchy_FollowOthersStay()
    {
        GameObject original = Bearer(out GameObject child, out GameObject outsider);
        GameObject clone = Object.Instantiate(original);
        Transform cloneChild = clone.transform.GetChild(0);
        var data = clone.GetComponent<Data>();
        Assert.That(data.Inside, Is.SameAs(cloneChild));
        Assert.That(data.Inside, Is.Not.SameAs(child.transform));
        Assert.That(data.Self, Is.SameAs(clone));
        Assert.That(data.Outside, Is.SameAs(outsider));
        Assert.That(data.List, Is.EqualTo(new Object[] { cloneChild.gameObject, outsider, null }));
        Assert.That(clone.name, Is.EqualTo("bearer(Clone)"));
        Assert.That(cloneChild.name, Is.EqualTo("child"));
    }

    [Test]
    public void Clone_SerializedFields_AreDeepCopies()
    {
        GameObject original = Bearer(out _, out _);
        var source = original.GetComponent<Data>();
        var copy = Object.Instantiate(source);
        Assert.That(copy.gameObject, Is.Not.SameAs(original));
        Assert.That(copy.Values, Is.EqualTo(source.Values).And.Not.SameAs(source.Values));
        Assert.That(copy.Nested.Label, Is.EqualTo("n"));
        Assert.That(copy.Nested, Is.Not.SameAs(source.Nested));
        Assert.That(copy.Pair.Weight, Is.EqualTo(2.5));
        Assert.That(copy.Hidden, Is.EqualTo(7));
        Assert.That(copy.Where, Is.EqualTo(new Vector3(1f, 2f, 3f)));
        Assert.That(copy.Mask.value, Is.EqualTo(5));
    }

    [Test]
    public void Clone_FieldsThatUnityDoesNotSerialize_StartFromTheirDefaults()
    {
        GameObject original = Bearer(out _, out _);
        var copy = Object.Instantiate(original).GetComponent<Data>();
        Assert.That(copy.Skipped, Is.Zero);
        Assert.That(copy.Private, Is.EqualTo(1));
        Assert.That(copy.Table, Is.Null);
        Assert.That(copy.Text, Is.Empty, "null text is written as an empty one");
        Assert.That(copy.Empty, Is.Not.Null.And.Empty);
        Assert.That(copy.Missing, Is.Not.Null, "a serializable class is never null");
    }

    [Test]
    public void Clone_SerializeReference_KeepsTypeAndSharing()
    {
        GameObject original = Bearer(out _, out _);
        var source = original.GetComponent<Data>();
        source.First = source.Second = new Round { Radius = 4f };
        var copy = Object.Instantiate(source);
        Assert.That(copy.First, Is.InstanceOf<Round>().And.SameAs(copy.Second));
        Assert.That(copy.First, Is.Not.SameAs(source.First));
        Assert.That(((Round)copy.First).Radius, Is.EqualTo(4f));
    }

    [Test]
    public void Clone_SerializationCallbacks_SurroundTheCopy()
    {
        GameObject original = Bearer(out _, out _);
        var source = original.GetComponent<Data>();
        source.Table = new Dictionary<string, int> { ["a"] = 1 };
        source.UseTable = true;
        var copy = Object.Instantiate(source);
        Assert.That(copy.Table, Is.EqualTo(source.Table).And.Not.SameAs(source.Table));
    }

    [Test]
    public void Clone_OfAnInactiveObject_WakesWhenActivated()
    {
        Play();
        GameObject original = Asleep("a");
        original.AddComponent<Talker>();
        GameObject clone = Object.Instantiate(original);
        Assert.That(Diary.Entries, Has.No.Member("a(Clone).Awake"));
        clone.SetActive(true);
        Assert.That(Diary.Entries, Has.Member("a(Clone).Awake"));
    }

    [Test]
    public void Clone_WakesWithItsFieldsFilledAndItsParentSet()
    {
        Play();
        var parent = new GameObject("parent");
        GameObject original = Asleep("a");
        var witness = original.AddComponent<Witness>();
        witness.Number = 12;
        original.SetActive(true);
        var clone = Object.Instantiate(witness, parent.transform);
        Assert.That(clone.Seen, Is.EqualTo("12 under parent"));
    }

    [Test]
    public void Clone_Placed_HasThatPose()
    {
        var parent = new GameObject("parent");
        parent.transform.position = new Vector3(10f, 0f, 0f);
        var original = new GameObject("a");
        original.transform.localPosition = new Vector3(1f, 2f, 3f);
        Assert.That(Object.Instantiate(original, parent.transform).transform.position,
            Is.EqualTo(new Vector3(11f, 2f, 3f)));
        Assert.That(Object.Instantiate(original, parent.transform, true).transform.position,
            Is.EqualTo(new Vector3(1f, 2f, 3f)));
        Transform placed = Object.Instantiate(original, new Vector3(5f, 6f, 7f), Quaternion.Euler(0f, 90f, 0f),
            parent.transform).transform;
        Assert.That(placed.position, Is.EqualTo(new Vector3(5f, 6f, 7f)));
        Assert.That(placed.eulerAngles.y, Is.EqualTo(90f).Within(1e-3f));
    }

    [Test]
    public void Clone_BuiltInComponents_KeepTheirSettings()
    {
        var original = new GameObject("a", typeof(Camera), typeof(MeshRenderer)) { layer = 4, tag = "Player" };
        original.GetComponent<Camera>().fieldOfView = 13f;
        original.GetComponent<MeshRenderer>().enabled = false;
        GameObject clone = Object.Instantiate(original);
        Assert.That(clone.GetComponent<Camera>().fieldOfView, Is.EqualTo(13f));
        Assert.That(clone.GetComponent<MeshRenderer>().enabled, Is.False);
        Assert.That(clone.layer == 4 && clone.CompareTag("Player"));
    }

    [Test]
    public void LODGroup_Cloned_HoldsTheCloneRenderers()
    {
        var original = new GameObject("a", typeof(LODGroup), typeof(MeshRenderer));
        original.GetComponent<LODGroup>().SetLODs(new[] { new LOD(0.5f, new[] { original.GetComponent<Renderer>() }) });
        GameObject clone = Object.Instantiate(original);
        LOD[] levels = clone.GetComponent<LODGroup>().GetLODs();
        Assert.That(levels[0].renderers, Is.EqualTo(new[] { clone.GetComponent<Renderer>() }));
        Assert.That(clone.GetComponent<Renderer>().LODGroup, Is.SameAs(clone.GetComponent<LODGroup>()));
    }

    [Test]
    public void Clone_OfADestroyedObject_IsRefused()
    {
        var item = new GameObject("a");
        Object.DestroyImmediate(item);
        Assert.Throws<ArgumentException>(() => Object.Instantiate(item));
    }

    static GameObject Bearer(out GameObject child, out GameObject outsider)
    {
        var bearer = new GameObject("bearer");
        child = new GameObject("child");
        child.transform.SetParent(bearer.transform);
        outsider = new GameObject("outsider");
        var data = bearer.AddComponent<Data>();
        data.Inside = child.transform;
        data.Self = bearer;
        data.Outside = outsider;
        data.List = new List<GameObject> { child, outsider, null };
        data.Values = new[] { 1f, 2f };
        data.Nested = new Nested { Label = "n" };
        data.Pair = new Pair { Weight = 2.5 };
        data.Where = new Vector3(1f, 2f, 3f);
        data.Mask = 5;
        data.Fill();
        return bearer;
    }

    [Serializable]
    internal sealed class Nested
    {
        public string Label;
    }

    [Serializable]
    internal struct Pair
    {
        public double Weight;
    }

    internal interface IShape
    {
    }

    [Serializable]
    internal sealed class Round : IShape
    {
        public float Radius;
    }

    internal sealed class Data : MonoBehaviour, ISerializationCallbackReceiver
    {
        public Transform Inside;
        public GameObject Self;
        public GameObject Outside;
        public List<GameObject> List;
        public float[] Values;
        public Nested Nested;
        public Pair Pair;
        public Vector3 Where;
        public LayerMask Mask;
        public string Text;
        public List<int> Empty;
        public Nested Missing;
        public bool UseTable;
        [SerializeReference] public IShape First;
        [SerializeReference] public IShape Second;
        [NonSerialized] public int Skipped;
        public Dictionary<string, int> Table;

        [SerializeField] int _hidden;
        [SerializeField] List<string> _keys;
        int _private = 1;

        internal int Hidden => _hidden;
        internal int Private => _private;

        public void OnBeforeSerialize() => _keys = Table is null ? null : new List<string>(Table.Keys);

        public void OnAfterDeserialize()
        {
            if (!UseTable)
                return;
            Table = new Dictionary<string, int>();
            foreach (string key in _keys)
                Table.Add(key, 1);
        }

        internal void Fill()
        {
            _hidden = 7;
            _private = 99;
            Skipped = 99;
            Missing = null;
            Text = null;
            Empty = null;
        }
    }

    internal sealed class Witness : MonoBehaviour
    {
        public int Number;
        [NonSerialized] public string Seen;

        void Awake() => Seen = $"{Number} under {(transform.parent == null ? "nothing" : transform.parent.name)}";
    }
}
