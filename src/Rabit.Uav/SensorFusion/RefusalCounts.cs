using System;
using System.Collections.Immutable;

namespace Rabit.Uav.SensorFusion;

/// <summary>Counts refused reports by vehicle and reason: 256 vehicles at most, so that its room is fixed.</summary>
internal sealed class RefusalCounts
{
    private const int Faults = (int)ReportFault.Description + 1;

    private readonly long[] _counts = new long[256 * Faults];
    private ImmutableArray<RefusedReports> _closed = [];
    private bool _isChanged;

    public void Add(byte source, ReportFault fault, long count = 1)
    {
        _counts[(source * Faults) + (int)fault] += count;
        _isChanged |= count > 0;
    }

    /// <summary>Those above 0, by vehicle and reason; the array of before where nothing was refused since.</summary>
    public ImmutableArray<RefusedReports> Close()
    {
        if (!_isChanged)
            return _closed;
        _isChanged = false;
        var closed = ImmutableArray.CreateBuilder<RefusedReports>();
        for (int i = 0; i < _counts.Length; i++)
        {
            if (_counts[i] > 0)
                closed.Add(new RefusedReports((byte)(i / Faults), (ReportFault)(i % Faults), _counts[i]));
        }

        return _closed = closed.ToImmutable();
    }
}
