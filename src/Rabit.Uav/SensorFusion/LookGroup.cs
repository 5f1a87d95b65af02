using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>The reports of one picture, until its look comes.</summary>
internal sealed class LookGroup
{
    public byte Source { get; private set; }

    public long Look { get; private set; }

    /// <summary>When the first of them came to us.</summary>
    public TimeSpan Since { get; private set; }

    /// <summary>How many came, those that were not believed too.</summary>
    public int Arrived { get; set; }

    public List<TargetReport> Reports { get; } = [];

    public void Begin(byte source, long look, TimeSpan since)
    {
        (Source, Look, Since, Arrived) = (source, look, since, 0);
        Reports.Clear();
    }
}
