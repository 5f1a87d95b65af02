using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The recording of the links.
public sealed partial class HealthManager
{
    private readonly MessageSubscriber<RecordingStatus>? _recording;
    private readonly HealthRuleSet<RecordingFacts> _recordingRules = new(HealthRules.OfRecording);
    private readonly WindowedIncrease _recordingLosses = new();

    private void EvaluateRecording(TimeSpan now)
    {
        if (_recording is null)
            return;
        _recording.Fetch();
        ref readonly RecordingStatus status = ref _recording.Value;
        long missing = status.FramesDropped + status.FramesLost;
        bool isLosing = _recordingLosses.Update(missing, now, _options.RecentWindow);
        _recordingRules.Evaluate(
            new RecordingFacts(missing, isLosing), subject: null, _options, now, _findings);
    }
}
