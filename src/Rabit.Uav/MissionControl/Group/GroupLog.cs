using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>Logs which vehicles of the group are received, and which are not any more. One thread.</summary>
internal sealed class GroupLog(Action<string> log)
{
    private readonly SortedSet<byte> _present = [];
    private readonly HashSet<byte> _now = [];
    private readonly HashSet<byte> _twice = [];
    private readonly HashSet<byte> _elsewhere = [];

    /// <param name="present">Those of the group that are received.</param>
    /// <param name="all">All that ever were of it.</param>
    /// <param name="elsewhere">Those that are received and fly another mission.</param>
    public void Update(IEnumerable<byte> present, IEnumerable<byte> all, IReadOnlyList<byte> elsewhere)
    {
        _now.Clear();
        _now.UnionWith(present);
        foreach (byte id in all)
        {
            if (_now.Contains(id) && _present.Add(id))
                log($"vehicle {MissionNumbers.Of(id)} is in the group");
            else if (!_now.Contains(id) && _present.Remove(id) && !elsewhere.Contains(id))
                log($"vehicle {MissionNumbers.Of(id)} is not received any more");
        }

        _elsewhere.ExceptWith(_now);
        foreach (byte id in elsewhere)
        {
            if (_elsewhere.Add(id))
            {
                log($"vehicle {MissionNumbers.Of(id)} is not of our group: the area, keepOuts, lane spacing or heading "
                    + "of its mission are others; nothing is shared with it but the air");
            }
        }
    }

    /// <param name="id">The system id of another vehicle.</param>
    /// <param name="metres">How far from it another one with that id lands; null for none.</param>
    public void UpdateTwice(byte id, double? metres)
    {
        if (metres is { } apart && _twice.Add(id))
        {
            log($"two vehicles have the system id {MissionNumbers.Of(id)}, {MissionNumbers.Of(apart)} m apart: the one "
                + "that was here first is the one of the group, the other one is left out until it has another id");
        }
        else if (metres is null && _twice.Remove(id))
        {
            log($"only one vehicle has the system id {MissionNumbers.Of(id)} now");
        }
    }
}
