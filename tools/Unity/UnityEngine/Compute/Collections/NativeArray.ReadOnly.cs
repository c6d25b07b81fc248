using System;
using System.Collections;
using System.Collections.Generic;

namespace Unity.Collections;

public partial struct NativeArray<T>
{
    public struct ReadOnly : IEnumerable<T>
    {
        NativeArray<T> _array;

        internal ReadOnly(NativeArray<T> array) => _array = array;

        public int Length => _array.Length;

        public bool IsCreated => _array.IsCreated;

        public T this[int index] => _array[index];

        public static implicit operator ReadOnlySpan<T>(in ReadOnly source) => source.AsReadOnlySpan();

        public readonly ReadOnlySpan<T> AsReadOnlySpan() => _array.AsReadOnlySpan();

        public void CopyTo(T[] array) => Copy(this, array);

        public void CopyTo(NativeArray<T> array) => Copy(this, array);

        public T[] ToArray() => _array.ToArray();

        public Enumerator GetEnumerator() => new(in this);

        IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        public struct Enumerator : IEnumerator<T>
        {
            ReadOnly _array;
            int _index;

            public Enumerator(in ReadOnly array) => (_array, _index) = (array, -1);

            public T Current => _array[_index];

            object IEnumerator.Current => Current;

            public bool MoveNext() => ++_index < _array.Length;

            public void Reset() => _index = -1;

            public void Dispose()
            {
            }
        }
    }
}
