using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Takes the camera's pictures, finds targets in them by colour and form, and says where on the ground they stand, how uncertain that is,
/// and which ground was seen. What it does, and where the camera looks, comes from Mission Control by message.
/// </summary>
/// <remarks>
/// A picture is located with the pose at the middle of its exposure, between the samples that the autopilot sent before and after; until
/// those have come it waits; without them it is drawn on by a tenth of a second at most, with a larger covariance, or refused. It owns the buffers of the pictures it holds and gives all back.
/// </remarks>
public sealed class ImageProcessingManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "image processing";

    internal const string NoPose = "no pose for the time of the picture";
    internal const string PoseTooOld = "the picture is older than all poses that are known";
    internal const string PoseGap = "the poses around the time of the picture are too far apart";
    internal const string NoRoom = "too many pictures wait for their poses";

    // How often it looks for poses while a picture waits for one, and otherwise.
    private static readonly TimeSpan WaitingCycle = TimeSpan.FromMilliseconds(20);
    private static readonly TimeSpan IdleCycle = TimeSpan.FromMilliseconds(250);

    // With the idle cycle at least once a second.
    private static readonly TimeSpan StatusPeriod = TimeSpan.FromMilliseconds(750);

    // Pictures between two units of work; the newer ones are worth more.
    private const int FramesQueued = 2;

    // Some seconds of poses at 60 a second: more than the longest unit of work of anybody.
    private const int PosesQueued = 1000;

    private readonly ImageProcessingOptions _options;
    private readonly BlockingReader<CameraFrame>? _camera;
    private readonly PictureSearch? _search;
    private readonly QueueReceiver<PoseSample> _poseQueue;
    private readonly MessageSubscriber<ImagingCommand> _order;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly QueueSender<TargetReport> _reports;
    private readonly QueueSender<CameraObservation> _looks;
    private readonly QueueSender<CameraObservation> _searchedGround;
    private readonly MessagePublisher<ImagingStatus> _status;
    private readonly PoseHistory _poses;
    private readonly WaitingFrames _waiting;
    private readonly ImageChipBuffer _album;
    private readonly FrameNumbers _numbers = new();
    private ImagingStatus _next;
    private TimeSpan? _lastPost;

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <param name="camera">What is read; null where there is none, and then there is nothing to do but to say so.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public ImageProcessingManager(ImageProcessingOptions options, IReaderSource<CameraFrame>? camera)
        : base(ManagerName)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(camera is not null, nameof(options));
        _poses = new PoseHistory(_options.MaxPoseGap);
        if (camera is not null)
        {
            _camera = AttachReader("camera", camera, FramesQueued, QueueFullMode.DropOldest);
            _search = new PictureSearch(_options, _options.Camera!, _poses);
        }

        _poseQueue = Receive<PoseSample>(MessageNames.Poses, PosesQueued, QueueFullMode.DropOldest, wakeOnPush: false);
        _order = Subscribe<ImagingCommand>(MessageNames.ImagingCommand, wakeOnPost: true);
        _ownAddress = Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _reports = Send<TargetReport>(MessageNames.TargetReports);
        _looks = Send<CameraObservation>(MessageNames.Looks);
        _searchedGround = Send<CameraObservation>(MessageNames.SearchedGround);
        _status = Publish<ImagingStatus>(MessageNames.Imaging);
        _waiting = new WaitingFrames(_options.FramesWaiting);
        _album = new ImageChipBuffer(_options.MaxImageChips, _options.ImageChipSide);
        WakeUpDelay = IdleCycle;
    }

    /// <summary>Parts of pictures around the newest reports, oldest first: a snapshot. Any thread, at any time.</summary>
    public IReadOnlyList<ImageChip> ImageChips => _album.Kept;

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;
        _order.Fetch();
        _ownAddress.Fetch();
        while (_poseQueue.TryPop(out PoseSample sample))
            _poses.Add(sample);
        TakeFrames(now);
        if (_order.Value.Mode == ImagingMode.Search)
            SearchWaiting(now);
        else
            _waiting.Clear();
        PostStatus(now);
        WakeUpDelay = _waiting.Count > 0 ? WaitingCycle : IdleCycle;
    }

    /// <inheritdoc/>
    protected override void Shutdown() => _waiting.Clear();

    private void TakeFrames(TimeSpan now)
    {
        if (_camera is null)
            return;
        while (_camera.TryPop(out CameraFrame frame))
        {
            _next.Frames++;
            _next.LastFrameTime = now;
            _numbers.Take(frame.Number);
            if (_order.Value.Mode != ImagingMode.Search)
            {
                frame.Dispose();
                continue;
            }

            if (_waiting.IsFull)
                Refuse(0, NoRoom);
            if (!frame.Pixels.IsEmpty)
                frame.Pixels = frame.Pixels.HandTo(ManagerName);
            _waiting.Add(frame, now);
        }
    }

    private void SearchWaiting(TimeSpan now)
    {
        for (int i = 0; i < _waiting.Count;)
        {
            PoseLookup answer = FindPoses(_waiting[i], out Pose pose);
            if (answer == PoseLookup.Known)
                Search(i, pose);
            else if (answer != PoseLookup.NotYet)
                Refuse(i, answer == PoseLookup.Gap ? PoseGap : PoseTooOld);
            else if (now - _waiting.Since(i) < _options.PoseTimeout)
                i++;
            else if (_poses.Extrapolate(MiddleOf(_waiting[i]), _options.MaxExtrapolation, out pose) == PoseLookup.Extrapolated)
                Search(i, pose);
            else
                Refuse(i, NoPose);
        }
    }

    // Of the middle row, once the poses around the first and the last one are known too.
    private PoseLookup FindPoses(in CameraFrame frame, out Pose pose)
    {
        PoseLookup answer = _poses.Find(MiddleOf(frame), out pose);
        TimeSpan readout = LastRow();
        if (answer != PoseLookup.Known || readout == TimeSpan.Zero)
            return answer;
        PoseLookup first = _poses.Find(frame.MidExposure, out _);
        return first == PoseLookup.Known ? _poses.Find(frame.MidExposure + readout, out _) : first;
    }

    private TimeSpan MiddleOf(in CameraFrame frame) => frame.MidExposure + TimeSpan.FromTicks(LastRow().Ticks / 2);

    // A frame is here only with a camera.
    private TimeSpan LastRow() => _options.Camera!.ReadoutOf(_options.Camera.Height - 1);

    private void Search(int index, in Pose pose)
    {
        // Given back whatever comes, also an exception.
        using CameraFrame frame = _waiting.TakeOut(index);
        string? refusal = _search!.Search(frame, pose, _order.Value, _ownAddress.Value.SystemId);
        if (refusal is not null)
        {
            CountRefusal(refusal);
            return;
        }

        _next.Looks++;
        _next.ReportsDropped += _search.Cut;
        foreach (ref readonly TargetReport report in _search.Reports)
        {
            if (_reports.Push(report) == PushResult.Rejected)
                _next.ReportsDropped++;
            else
                _next.Reports++;
            _album.Add(report.PictureNumber, report.Index, frame.Pixels.Array, frame.Width, frame.Height, report.CentreX, report.CentreY);
        }

        _next.LastObservation = _search.Look;

        // What finds no room is in the books of the queue.
        _looks.Push(_search.Look);
        _searchedGround.Push(_search.Look);
    }

    private void Refuse(int index, string why)
    {
        _waiting.TakeOut(index).Dispose();
        CountRefusal(why);
    }

    private void CountRefusal(string why)
    {
        _next.FramesRefused++;
        _next.LastRefusal = why;
    }

    // At once when the order or the camera is another or a picture was searched, else so that it is told at least once a second.
    private void PostStatus(TimeSpan now)
    {
        _next.HasCamera = _camera is not null;
        _next.Mode = _order.Value.Mode;
        _next.FramesDropped = _numbers.Lost;
        _next.HasEnded = _camera?.State is DeviceState.Ended or DeviceState.Faulted;
        if (_next.HasEnded && _next.Fault is null && _camera?.Fault is { } fault)
            _next.Fault = $"{fault.GetType().Name}: {fault.Message}";
        ref ImagingStatus posted = ref _status.Value;
        bool isNews = _lastPost is null || posted.Mode != _next.Mode || posted.HasEnded != _next.HasEnded || posted.Looks != _next.Looks;
        if (!isNews && now - _lastPost < StatusPeriod)
            return;
        posted = _next;
        _status.Post();
        _lastPost = now;
    }
}
