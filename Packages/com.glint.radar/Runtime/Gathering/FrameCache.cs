using System.Collections.Generic;

namespace Glint
{
    /// <summary>
    /// A cache from one gather to the next. Entries that a gather does not request are removed at its end.
    /// </summary>
    sealed class FrameCache<TKey, TValue> where TValue : class, new()
    {
        Dictionary<TKey, TValue> _now = new Dictionary<TKey, TValue>();
        Dictionary<TKey, TValue> _before = new Dictionary<TKey, TValue>();

        public void Begin()
        {
            (_now, _before) = (_before, _now);
            _now.Clear();
        }

        /// <summary>The value of the last gather, or a new one.</summary>
        /// <param name="first">True for the first request since <see cref="Begin"/>.</param>
        public TValue Get(TKey key, out bool first)
        {
            first = !_now.TryGetValue(key, out var value);
            if (!first)
                return value;
            if (!_before.TryGetValue(key, out value))
                value = new TValue();
            _now.Add(key, value);
            return value;
        }

        public void End() => _before.Clear();

        /// <summary>The values of the last gather.</summary>
        public IEnumerable<TValue> Values => _now.Values;

        public void Clear()
        {
            _now.Clear();
            _before.Clear();
        }
    }
}
