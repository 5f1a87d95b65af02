using System.Collections.Generic;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Remembers which reports arrived, so that each counts once however often a link delivers it. The oldest are
/// forgotten.
/// </summary>
internal sealed class SeenReports(int capacity)
{
    private readonly HashSet<ReportKey> _seen = [];
    private readonly ReportKey[] _order = new ReportKey[capacity];
    private int _next;

    /// <summary>Whether a report is new; it is remembered then.</summary>
    public bool Add(ReportKey key)
    {
        if (!_seen.Add(key))
            return false;
        if (_seen.Count > capacity)
            _seen.Remove(_order[_next]);
        _order[_next] = key;
        _next = (_next + 1) % capacity;
        return true;
    }
}
