using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>The reports of one picture of another vehicle, until they are used.</summary>
internal sealed class ReportGroup
{
    public byte Source { get; private set; }

    public long Picture { get; private set; }

    /// <summary>When the first of them arrived.</summary>
    public TimeSpan Since { get; private set; }

    public List<TargetReport> Reports { get; } = [];

    public void Begin(byte source, long picture, TimeSpan since)
    {
        (Source, Picture, Since) = (source, picture, since);
        Reports.Clear();
    }
}
