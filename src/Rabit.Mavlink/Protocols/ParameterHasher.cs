using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>
/// Computes the hash of the parameters that are served. The order of the names is found once, so that nothing is
/// allocated while their number stays.
/// </summary>
internal sealed class ParameterHasher(
    IMavlinkParameterStore store, MavlinkParameterEncoding encoding, Predicate<string>? isVolatile)
{
    public static readonly Text16 Name = new("_HASH_CHECK");

    private readonly Predicate<string> _isVolatile = isVolatile ?? MavlinkParameterHash.IsVolatile;

    // The names that count, in their order, with their places in the list.
    private (string Name, int Index)[] _sorted = [];
    private int _count = -1;

    public uint Compute()
    {
        if (_count != store.Count)
            Sort();
        uint hash = 0;
        foreach ((string name, int index) in _sorted)
        {
            MavlinkParameterValue parameter = store[index];
            uint bits = MavlinkParameter.EncodeNearest(parameter.Value, parameter.Type, encoding);
            hash = MavlinkParameterHash.Add(MavlinkParameterHash.Add(hash, name), bits);
        }

        return hash;
    }

    private void Sort()
    {
        _count = store.Count;
        var all = new (string Name, int Index)[_count];
        for (int i = 0; i < _count; i++)
            all[i] = (store[i].Name.ToString(), i);
        _sorted = Array.FindAll(all, entry => !_isVolatile(entry.Name));
        Array.Sort(_sorted, (a, b) => string.CompareOrdinal(a.Name, b.Name));
    }
}
