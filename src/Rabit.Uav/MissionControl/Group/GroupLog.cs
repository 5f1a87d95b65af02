using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>Logs which vehicles of the group are received, and which are not any more. One thread.</summary>
internal sealed class GroupLog(Action<string> log)
{
    private readonly SortedSet<byte> _present = [];
    private readonly HashSet<byte> _now = [];

    public void Update(IEnumerable<byte> present, IEnumerable<byte> all)
    {
        _now.Clear();
        _now.UnionWith(present);
        foreach (byte id in all)
        {
            if (_now.Contains(id) && _present.Add(id))
                log($"vehicle {MissionNumbers.Of(id)} is in the group");
            else if (!_now.Contains(id) && _present.Remove(id))
                log($"vehicle {MissionNumbers.Of(id)} is not received any more");
        }
    }
}
