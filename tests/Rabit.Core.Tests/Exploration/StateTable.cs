using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// The states that are known, with the number of interleavings from each on: 24 bytes each in two arrays, for there are
/// many.
/// </summary>
internal sealed class StateTable
{
    private StateKey[] _keys = new StateKey[1024];
    private double[] _interleavings = new double[1024];

    public int Count { get; private set; }

    public void Clear()
    {
        Array.Clear(_keys, 0, _keys.Length);
        Count = 0;
    }

    public bool TryGet(in StateKey key, out double interleavings)
    {
        int slot = SlotOf(key);
        interleavings = _interleavings[slot];
        return !_keys[slot].IsNone;
    }

    public void Add(in StateKey key, double interleavings)
    {
        if (Count >= _keys.Length / 4 * 3)
            Grow();
        int slot = SlotOf(key);
        _keys[slot] = key;
        _interleavings[slot] = interleavings;
        Count++;
    }

    // Where the key is or would be: from its own place on, the first that is its or free.
    private int SlotOf(in StateKey key)
    {
        int mask = _keys.Length - 1;
        int slot = key.GetHashCode() & mask;
        while (!_keys[slot].IsNone && !_keys[slot].Equals(key))
            slot = (slot + 1) & mask;
        return slot;
    }

    private void Grow()
    {
        StateKey[] keys = _keys;
        double[] interleavings = _interleavings;
        _keys = new StateKey[2 * keys.Length];
        _interleavings = new double[_keys.Length];
        for (int i = 0; i < keys.Length; i++)
        {
            if (keys[i].IsNone)
                continue;
            int slot = SlotOf(keys[i]);
            _keys[slot] = keys[i];
            _interleavings[slot] = interleavings[i];
        }
    }
}
