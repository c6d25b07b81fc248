using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class SerializedFieldsTests
{
    [Test]
    public void Fields_OfMixedKinds_AreThoseThatUnitySerializesInOrder()
    {
        string[] names = SerializedFields.Of(typeof(Mixed)).Select(field => field.Name).ToArray();
        Assert.That(names,
            Is.EqualTo(new[] { "Base", "Number", "Numbers", "Place", "Level", "_kept", "Data", "List", "_shape" }));
    }

    // The fields are only read by reflection.
#pragma warning disable CS0169, CS0649
    internal interface IShape
    {
    }

    internal enum Level
    {
        Low,
    }

    [Serializable]
    internal class Data
    {
        public int Value;
    }

    internal class Plain
    {
        public int Value;
    }

    internal class Ancestor : MonoBehaviour
    {
        public int Base;
        int _hidden;
    }

    internal sealed class Mixed : Ancestor
    {
        public const int Constant = 1;
        public static int Shared;
        public readonly int Fixed;
        public double Number;
        public float[] Numbers;
        public Vector3 Place;
        public Level Level;
        [SerializeField] int _kept;
        public Data Data;
        public List<Data> List;
        [SerializeReference] IShape _shape;
        public float[,] Grid;
        public float[][] Jagged;
        public int? Maybe;
        public Dictionary<string, int> Table;
        public Action Call;
        public IShape Interface;
        public Guid Id;
        public Plain Plain;
        [NonSerialized] public int Skipped;
        int _private;

        public int Property { get; set; }
    }
#pragma warning restore CS0169, CS0649
}
