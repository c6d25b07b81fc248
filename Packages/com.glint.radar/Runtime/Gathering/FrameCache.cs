using System.Collections.Generic;

namespace Glint
{
    /// <summary>
    /// What is kept of one gather for the next, by key. What a gather does not ask for is forgotten when it ends.
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

        /// <summary>The value of the gather before, or a new one.</summary>
        /// <param name="first">True the first time since <see cref="Begin"/>.</param>
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

        public void Clear()
        {
            _now.Clear();
            _before.Clear();
        }
    }
}
