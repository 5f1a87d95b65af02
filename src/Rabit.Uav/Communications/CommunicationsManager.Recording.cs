using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// The recording of the links: each frame that was accepted, once, and each of ours that went out, once. What is
// forwarded is there as it came in; copies over a second link, filtered and rejected frames are not.
public sealed partial class CommunicationsManager
{
    private readonly FrameRecorder? _recorder;
    private readonly BlockingWriter<FrameToRecord>? _recording;
    private readonly MessagePublisher<RecordingStatus>? _recordingStatus;
    private readonly DropReport _recordingDrops = new();

    // Of our frames in the log, by sender: their numbers on the links are of each link.
    private readonly Dictionary<int, byte> _recordedSequences = [];
    private long _notRecorded;

    /// <summary>What was recorded of the links; null where nothing is. Any thread.</summary>
    public RecordingStatus? SummariseRecording() => _recorder is { } recorder
        ? new RecordingStatus
        {
            File = recorder.File,
            Files = recorder.FileCount,
            FilesDeleted = recorder.FilesDeleted,
            Frames = recorder.Frames,
            Bytes = recorder.Bytes,
            FramesDropped = Interlocked.Read(ref _notRecorded) + _recording!.Discarded,
            FramesLost = recorder.Lost,
            Fault = recorder.Fault,
        }
        : null;

    private static FrameRecorder MakeRecorder(RecordingOptions options)
    {
        RecordingOptions copy = options.Copy();
        try
        {
            copy.CheckFolder(nameof(options));
        }
        catch (ArgumentException) when (!copy.IsRequired)
        {
            // What becomes of the first frame says it again, in the log and in the health report.
        }

        return new FrameRecorder(copy);
    }

    private void Record(in LinkFrame frame)
    {
        if (_recording is not null)
            Record(frame.IsChecked ? frame.Frame.WithoutSignature() : frame.Frame, frame.Time, frame.UtcMicroseconds);
    }

    private void RecordOwn(in MavlinkFrame frame, byte crcExtra)
    {
        if (_recording is null)
            return;
        int sender = (frame.SystemId << 8) | frame.ComponentId;
        _recordedSequences.TryGetValue(sender, out byte sequence);
        _recordedSequences[sender] = unchecked((byte)(sequence + 1));
        Record(frame.WithSequence(sequence, crcExtra), Now, UtcMicroseconds(Clock.GetUtcNow()));
    }

    private void Record(in MavlinkFrame frame, TimeSpan time, long utcMicroseconds)
    {
        var record = new FrameToRecord { Frame = frame, Time = time, UtcMicroseconds = utcMicroseconds };
        if (_recording!.Push(record) == PushResult.Rejected)
            Interlocked.Increment(ref _notRecorded);
    }

    private void ReportRecording(bool isEnd)
    {
        if (SummariseRecording() is not { } status)
            return;
        _recordingStatus!.Value = status;
        _recordingStatus.Post();
        if (!_recordingDrops.IsDue(status.FramesDropped + status.FramesLost, Now, isEnd))
            return;
        Log(status.Fault is { } fault
            ? $"recording: {status.FramesLost} frames so far could not be written ({fault}), "
                + $"{status.FramesDropped} had no room to wait"
            : $"recording: {status.FramesDropped} frames so far had no room to wait for the disk, "
                + $"{status.FramesLost} could not be written");
    }

    private static long UtcMicroseconds(DateTimeOffset utc)
        => (utc - DateTimeOffset.FromUnixTimeSeconds(0)).Ticks / (TimeSpan.TicksPerMillisecond / 1000);
}
