namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rule for the recording of the links.</summary>
internal readonly struct RecordingFacts(long framesMissing, bool hasLostRecently)
{
    /// <summary>Frames that are not in the files, since the disk was too slow, or could not be written.</summary>
    public long FramesMissing { get; } = framesMissing;

    public bool HasLostRecently { get; } = hasLostRecently;
}
