using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The material of a surface, as an asset: a perfect conductor, a half-space, layers on either, or published
    /// values. A <see cref="RadarSurface"/> assigns it to objects.
    /// </summary>
    [CreateAssetMenu(menuName = "Glint/Radar Material")]
    [HelpPage("materials.md")]
    public sealed class RadarMaterial : ScriptableObject
    {
        [SerializeField, Tooltip("What is behind the layers, or Published for a material of the library.")]
        RadarMaterialKind _kind;

        [SerializeField, Tooltip("Name of a published material, such as itu_concrete.")]
        string _published = "";

        [SerializeField, Tooltip("Layers on the conductor or half-space, outermost first.")]
        List<RadarLayer> _layers = new List<RadarLayer>();

        [SerializeField, Tooltip("Medium behind the layers.")]
        RadarMedium _halfSpace = new RadarMedium();

        [SerializeField, Tooltip("RMS slope of the surface about its mesh in one direction, 0.001 to 1: for a Radar Screen.")]
        double _slope = SurfaceMaterial.DefaultSlope;

        [SerializeField, Tooltip("Diffuse echo for a Radar Screen: cross section over the area across the ray, dB.")]
        double _gammaDb = SurfaceMaterial.DefaultGammaDb;

        // Of a material that a mesh file names; not stored.
        SurfaceMaterial _surface;

        /// <summary>What is behind the layers, or Published.</summary>
        public RadarMaterialKind Kind { get => _kind; set => _kind = value; }

        /// <summary>Name of a <see cref="PublishedMaterial"/>; read if the kind is Published.</summary>
        public string Published { get => _published; set => _published = value; }

        /// <summary>Outermost first; read unless the kind is Published.</summary>
        public List<RadarLayer> Layers { get => _layers; set => _layers = value; }

        /// <summary>Medium behind the layers; read if the kind is HalfSpace.</summary>
        public RadarMedium HalfSpace { get => _halfSpace; set => _halfSpace = value; }

        /// <inheritdoc cref="SurfaceMaterial.Slope"/>
        public double Slope { get => _slope; set => _slope = value; }

        /// <inheritdoc cref="SurfaceMaterial.GammaDb"/>
        public double GammaDb { get => _gammaDb; set => _gammaDb = value; }

        /// <summary>A material that is not stored as an asset.</summary>
        public static RadarMaterial Of(SurfaceMaterial surface)
        {
            var material = CreateInstance<RadarMaterial>();
            material.name = surface.Name;
            material._surface = surface;
            return material;
        }

        /// <summary>The material in scenes and results.</summary>
        /// <exception cref="GlintException">A value is refused; the message names this material.</exception>
        public SurfaceMaterial ToSurface()
        {
            if (_surface != null)
                return _surface;
            try
            {
                var surface = _kind == RadarMaterialKind.Published
                    ? PublishedMaterial.Find(_published).ToSurface(name)
                    : new SurfaceMaterial(name, _layers.Select(layer => layer.ToLayer()),
                        _kind == RadarMaterialKind.HalfSpace ? _halfSpace.ToMedium() : null);
                return surface.WithScatter(_slope, _gammaDb);
            }
            catch (GlintException refusal)
            {
                throw new GlintException($"Radar Material '{name}': {refusal.Message}", refusal);
            }
        }
    }

    /// <summary>What a <see cref="RadarMaterial"/> consists of. Stored as numbers.</summary>
    public enum RadarMaterialKind
    {
        /// <summary>Layers on a perfect conductor; without layers the conductor itself.</summary>
        Conductor = 0,

        /// <summary>Layers on a half-space of one medium; without layers the half-space itself.</summary>
        HalfSpace = 1,

        /// <summary>A material of the library.</summary>
        Published = 2,
    }

    /// <summary>A layer of a <see cref="RadarMaterial"/>.</summary>
    [Serializable]
    public sealed class RadarLayer
    {
        [SerializeField, Tooltip("Medium of the layer.")]
        RadarMedium _medium = new RadarMedium();

        [SerializeField, Min(0), Tooltip("Thickness in metres.")]
        double _thickness;

        /// <summary>Medium of the layer.</summary>
        public RadarMedium Medium { get => _medium; set => _medium = value; }

        /// <summary>Metres, 0 or more.</summary>
        public double Thickness { get => _thickness; set => _thickness = value; }

        internal MaterialLayer ToLayer() => new MaterialLayer(_medium.ToMedium(), _thickness);
    }

    /// <summary>A medium of a <see cref="RadarMaterial"/>: a published one, or values over frequency.</summary>
    [Serializable]
    public sealed class RadarMedium
    {
        [SerializeField, Tooltip("Name of a published material, such as ptfe. Empty: the values below.")]
        string _published = "";

        [SerializeField, Tooltip("Relative permittivity e' - j e'' and permeability mu' - j mu''. One element: the "
            + "same at every frequency. Several, in order of frequency in Hz: interpolated, no data outside.")]
        List<MediumSample> _values = new List<MediumSample> { new MediumSample(0, 1, 0) };

        /// <summary>Name of a <see cref="PublishedMaterial"/>; empty: <see cref="Values"/>.</summary>
        public string Published { get => _published; set => _published = value; }

        /// <summary>
        /// One element: the same at every frequency, its own is not read. Several: a table in order of frequency.
        /// </summary>
        public List<MediumSample> Values { get => _values; set => _values = value; }

        internal Medium ToMedium()
        {
            if (!string.IsNullOrEmpty(_published))
                return PublishedMaterial.Find(_published).Medium;
            if (_values.Count != 1)
                return Medium.Table(_values);
            var only = _values[0];
            return Medium.Constant(only.Permittivity, only.PermittivityLoss, only.Permeability, only.PermeabilityLoss);
        }
    }
}
