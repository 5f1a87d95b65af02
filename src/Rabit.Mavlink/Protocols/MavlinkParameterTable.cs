using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// The parameters of a vehicle, by their place in its list. One thread; allocates only where the list is longer than
/// any before.
/// </summary>
public sealed class MavlinkParameterTable
{
    private MavlinkParameter[] _entries = [];

    /// <summary>How many parameters the vehicle reports to have.</summary>
    public int Count { get; private set; }

    /// <summary>How many of them are not known yet.</summary>
    public int Missing { get; private set; }

    /// <summary>One parameter.</summary>
    /// <param name="index">0 to <see cref="Count"/> - 1.</param>
    /// <returns>The parameter; default where it is not known yet.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such index.</exception>
    public MavlinkParameter this[int index] => (uint)index < (uint)Count
        ? _entries[index]
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"There are {Count} parameters.");

    /// <summary>Looks a parameter up.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="parameter">The parameter.</param>
    /// <returns>Whether it is known.</returns>
    public bool TryGet(string name, out MavlinkParameter parameter)
    {
        for (int i = 0; i < Count; i++)
        {
            if (!IsKnown(i) || !_entries[i].Name.TextEquals(name))
                continue;
            parameter = _entries[i];
            return true;
        }

        parameter = default;
        return false;
    }

    internal bool IsKnown(int index) => _entries[index].Name[0] != 0;

    internal void Reset(int count)
    {
        if (_entries.Length < count)
            _entries = new MavlinkParameter[count];
        else
            Array.Clear(_entries, 0, _entries.Length);
        Count = Missing = count;
    }

    /// <summary>Enters a parameter at its index.</summary>
    /// <returns>False where another one is there: the list has shifted.</returns>
    internal bool TryEnter(in MavlinkParameter parameter, out bool isNew)
    {
        isNew = !IsKnown(parameter.Index);
        if (!isNew && _entries[parameter.Index].Name != parameter.Name)
            return false;
        _entries[parameter.Index] = parameter;
        if (isNew)
            Missing--;
        return true;
    }

    /// <summary>Takes a new value of a known parameter.</summary>
    internal void Update(in MavlinkParameter parameter)
    {
        if (parameter.Index < Count && _entries[parameter.Index].Name == parameter.Name)
        {
            _entries[parameter.Index] = parameter;
            return;
        }

        for (int i = 0; i < Count; i++)
        {
            if (_entries[i].Name == parameter.Name)
                _entries[i] = parameter with { Index = i };
        }
    }

    /// <summary>The next index from a place on, round the end, whose parameter is missing; -1 where none is.</summary>
    internal int NextMissing(int from)
    {
        for (int step = 0; step < Count && Missing > 0; step++)
        {
            int index = (from + step) % Count;
            if (!IsKnown(index))
                return index;
        }

        return -1;
    }
}
