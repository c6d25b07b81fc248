using System;
using System.Collections.Generic;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>A file of named arrays.</summary>
    public interface IArrayFile : IDisposable
    {
        /// <summary>Adds an array of doubles.</summary>
        /// <param name="name">Letters, digits and _, a letter first, at most 63 characters.</param>
        /// <param name="values">As many as the sizes have, the last index changing fastest.</param>
        void Add(string name, int[] sizes, IEnumerable<double> values);

        /// <summary>Adds an array of complex numbers of two doubles each.</summary>
        /// <inheritdoc cref="Add(string, int[], IEnumerable{double})" path="/param"/>
        void Add(string name, int[] sizes, IEnumerable<Complex> values);
    }
}
