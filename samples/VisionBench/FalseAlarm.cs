using Rabit.Uav.ImageProcessing;

namespace VisionBench;

/// <summary>A detection where there is no target of its class.</summary>
internal sealed class FalseAlarm(TargetDetection detection, string on)
{
    public TargetDetection Detection { get; } = detection;

    /// <summary>What is there.</summary>
    public string On { get; } = on;
}
