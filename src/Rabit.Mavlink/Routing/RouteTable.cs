using System;
using System.Collections.Generic;

namespace Rabit.Mavlink.Routing;

/// <summary>Which component was seen on which links. Bounded; allocates nothing after it was made.</summary>
internal sealed class RouteTable
{
    private const int RestartMs = 1000;

    private readonly int _capacity;
    private readonly Dictionary<int, ulong> _linksByComponent;
    private readonly int[] _components;
    private readonly ulong[] _linksBySystem = new ulong[256];
    private readonly Dictionary<int, uint> _bootTimeMs;

    public RouteTable(int capacity)
    {
        _capacity = capacity;
        _linksByComponent = new Dictionary<int, ulong>(capacity);
        _components = new int[capacity];
        _bootTimeMs = new Dictionary<int, uint>(capacity);
    }

    public int Count => _linksByComponent.Count;

    public ulong LinksOf(byte systemId) => _linksBySystem[systemId];

    public ulong LinksOf(byte systemId, byte componentId) =>
        _linksByComponent.TryGetValue(Key(systemId, componentId), out ulong links) ? links : 0;

    /// <summary>Returns false where there is no room for another component.</summary>
    public bool TryLearn(byte systemId, byte componentId, ulong link)
    {
        int key = Key(systemId, componentId);
        if (!_linksByComponent.TryGetValue(key, out ulong links))
        {
            if (Count == _capacity)
                return false;
            _components[Count] = key;
        }
        if ((links & link) == 0)
        {
            _linksByComponent[key] = links | link;
            _linksBySystem[systemId] |= link;
        }
        return true;
    }

    /// <summary>Forgets what was seen on these links.</summary>
    public void ForgetLinks(ulong links) => Keep(0, ~links);

    /// <summary>Forgets where a system was seen.</summary>
    public void ForgetSystem(byte systemId) => Keep(systemId, 0);

    /// <summary>Whether a time since boot of a component is a second or more before the one that it had.</summary>
    public bool IsRestarted(byte systemId, byte componentId, uint bootTimeMs)
        => _bootTimeMs.TryGetValue(Key(systemId, componentId), out uint before)
            && before - (long)bootTimeMs >= RestartMs;

    /// <summary>Notes the time since boot of a component, where there is room for it.</summary>
    public void NoteBootTime(byte systemId, byte componentId, uint bootTimeMs)
    {
        int key = Key(systemId, componentId);
        if (_bootTimeMs.ContainsKey(key) || _bootTimeMs.Count < _capacity)
            _bootTimeMs[key] = bootTimeMs;
    }

    /// <summary>Forgets where a component was seen.</summary>
    public void Forget(byte systemId, byte componentId)
    {
        int key = Key(systemId, componentId);
        if (!_linksByComponent.Remove(key))
            return;
        int last = Count;
        int at = Array.IndexOf(_components, key, 0, last + 1);
        _components[at] = _components[last];
        ulong links = 0;
        for (int i = 0; i < last; i++)
        {
            if (_components[i] >> 8 == systemId)
                links |= _linksByComponent[_components[i]];
        }

        _linksBySystem[systemId] = links;
    }

    // System 0 is every system.
    private void Keep(byte systemId, ulong mask)
    {
        int kept = 0;
        int count = Count;
        for (int i = 0; i < count; i++)
        {
            int key = _components[i];
            bool isMeant = systemId == 0 || key >> 8 == systemId;
            ulong links = _linksByComponent[key] & (isMeant ? mask : ulong.MaxValue);
            _linksByComponent.Remove(key);
            if (links == 0)
                continue;
            _linksByComponent.Add(key, links);
            _components[kept++] = key;
        }
        for (int system = 0; system < _linksBySystem.Length; system++)
        {
            if (systemId == 0 || system == systemId)
                _linksBySystem[system] &= mask;
        }
    }

    private static int Key(byte systemId, byte componentId) => (systemId << 8) | componentId;
}
