using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>The stored items of one type, and those of an upload until it is complete.</summary>
internal sealed class StoredMissionItems
{
    private MissionItemInt[] _items = [];
    private MissionItemInt[] _incoming = [];

    public int Count { get; private set; }

    /// <summary>0 where there are no items.</summary>
    public uint Id { get; private set; }

    /// <summary>Counts the changes.</summary>
    public int Version { get; private set; }

    /// <summary>What is not taken yet.</summary>
    public MavlinkMissionChange? Change { get; set; }

    public ReadOnlySpan<MissionItemInt> Items => _items.AsSpan(0, Count);

    public ReadOnlySpan<MissionItemInt> Incoming(int count) => _incoming.AsSpan(0, count);

    public void Reserve(int count)
    {
        if (_incoming.Length < count)
            _incoming = new MissionItemInt[count];
    }

    public void SetIncoming(int index, in MissionItemInt item) => _incoming[index] = item;

    /// <summary>The incoming items are those that are stored.</summary>
    public void Commit(int count)
    {
        (_items, _incoming) = (_incoming, _items);
        Count = count;
        Version++;
        Id = Count == 0 ? 0 : Hash(Items);
    }

    public void Store(MavMissionType type, ReadOnlySpan<MissionItemInt> items)
    {
        Reserve(items.Length);
        for (int i = 0; i < items.Length; i++)
        {
            _incoming[i] = items[i] with
            {
                Seq = (ushort)i,
                MissionType = type,
                TargetSystem = 0,
                TargetComponent = 0
            };
        }

        Commit(items.Length);
    }

    private static uint Hash(ReadOnlySpan<MissionItemInt> items)
    {
        uint hash = 0;
        foreach (ref readonly MissionItemInt item in items)
        {
            hash = MavlinkParameterHash.Add(hash, ((uint)item.Command << 8) | (uint)item.Frame);
            hash = MavlinkParameterHash.Add(hash, MavlinkParameter.FromFloat(item.Param1));
            hash = MavlinkParameterHash.Add(hash, MavlinkParameter.FromFloat(item.Param2));
            hash = MavlinkParameterHash.Add(hash, MavlinkParameter.FromFloat(item.Param3));
            hash = MavlinkParameterHash.Add(hash, MavlinkParameter.FromFloat(item.Param4));
            hash = MavlinkParameterHash.Add(hash, unchecked((uint)item.X));
            hash = MavlinkParameterHash.Add(hash, unchecked((uint)item.Y));
            hash = MavlinkParameterHash.Add(hash, MavlinkParameter.FromFloat(item.Z));
            hash = MavlinkParameterHash.Add(hash, item.Autocontinue);
        }

        return hash == 0 ? 1 : hash;
    }
}
