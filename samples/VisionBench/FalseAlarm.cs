using System;
using Rabit.Uav.ImageProcessing;

namespace VisionBench;

/// <summary>A detection where there is no target of its class.</summary>
internal sealed class FalseAlarm(TargetDetection detection, string on)
{
    public TargetDetection Detection { get; } = detection;

    /// <summary>What is there.</summary>
    public string On { get; } = on;

    public string Describe() => FormattableString.Invariant(
        $"{Detection.Class} {Detection.Score:0.00} on {On} at {Detection.CentreX:0.0}, {Detection.CentreY:0.0}, {Detection.SideMetres:0.00} m");
}
