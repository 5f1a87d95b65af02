using System.Collections.Generic;

namespace Rabit.Mavlink.Routing;

/// <summary>Which component was seen on which links. Bounded; allocates nothing after it was made.</summary>
internal sealed class RouteTable
{
    private readonly int _capacity;
    private readonly Dictionary<int, ulong> _linksByComponent;
    private readonly int[] _components;
    private readonly ulong[] _linksBySystem = new ulong[256];

    public RouteTable(int capacity)
    {
        _capacity = capacity;
        _linksByComponent = new Dictionary<int, ulong>(capacity);
        _components = new int[capacity];
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
