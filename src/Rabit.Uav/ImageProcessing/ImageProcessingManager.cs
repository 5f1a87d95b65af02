using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Searches the camera's pictures for targets (<see cref="ITargetDetector"/>), and reports where on the ground they
/// are, how uncertain that is, and which ground was seen. What to search for, and where the camera points, is a command
/// of Mission Control.
/// </summary>
/// <remarks>
/// A picture is geolocated with the pose at the middle of its exposure, interpolated between the samples of the
/// autopilot before and after; until those have arrived it waits. Without them the pose is extrapolated by a tenth of a
/// second at most, with a larger covariance, or the picture is refused. The manager owns the buffers of the pictures it
/// holds and gives all back.
/// </remarks>
public sealed class ImageProcessingManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "image processing";

    internal const string NoPose = "no pose for the time of the picture";
    internal const string InTheFuture = "the time of the picture is in the future";
    internal const string PoseTooOld = "the picture is older than all known poses";
    internal const string PoseGap = "the poses around the time of the picture are too far apart";
    internal const string GimbalSilent = "the gimbal no longer reports its attitude";
    internal const string NoRoom = "too many pictures wait for their poses";

    // Between two units of work, where nothing wakes it: for the status.
    private static readonly TimeSpan IdlePeriod = TimeSpan.FromMilliseconds(250);

    // With the idle period at least once a second.
    private static readonly TimeSpan StatusPeriod = TimeSpan.FromMilliseconds(750);

    // Three pictures at 2 Hz, or four where they come more slowly: one or two that are bad are no fault of the camera.
    private static readonly TimeSpan QualityWindow = TimeSpan.FromSeconds(1.5);
    private static readonly TimeSpan MaxQualityAge = TimeSpan.FromSeconds(10);

    // Pictures between two units of work; the newer ones are worth more.
    private const int FramesQueued = 2;

    // Some seconds of poses at 60 a second: more than the longest unit of work of any manager.
    private const int PosesQueued = 1000;

    private readonly ImageProcessingOptions _options;
    private readonly BlockingReader<CameraFrame>? _camera;
    private readonly ICamera? _source;
    private readonly PictureSearch? _search;
    private readonly LandingMarkerFinder? _landingMarker;
    private readonly QueueReceiver<PoseSample> _poseQueue;
    private readonly MessageSubscriber<ImagingCommand> _command;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly QueueSender<CameraObservation> _observations;
    private readonly QueueSender<CameraObservation> _searchedGround;
    private readonly MessagePublisher<ImagingStatus> _status;
    private readonly MessagePublisher<LandingTargetObservation> _landingTarget;
    private readonly PoseHistory _poses;
    private readonly WaitingFrames _waiting;
    private readonly ImageChipBuffer _imageChips;
    private readonly PictureOverviewBuffer _overviews;
    private readonly FrameNumbers _numbers = new();
    private readonly PictureWindow _window = new(QualityWindow, MaxQualityAge);
    private ImagingStatus _next;
    private TimeSpan? _lastPost;
    private string? _loggedFault;
    private TimeSpan _nextFaultLog;

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <param name="camera">
    /// What is read; null where there is none, and then there is nothing to do but to say so.
    /// </param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public ImageProcessingManager(ImageProcessingOptions options, IReaderSource<CameraFrame>? camera)
        : base(ManagerName)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options)))
            .ValidatedCopy(camera is not null, nameof(options));
        _poses = new PoseHistory(_options.MaxPoseGap, usesGimbal: _options.Mount.FixedBodyFromCamera is null);
        if (camera is not null)
        {
            _camera = AttachReader("camera", camera, FramesQueued, QueueFullMode.DropOldest);
            _source = camera as ICamera;
            _search = new PictureSearch(_options, _options.Camera!, _poses, () => Now);
            if (_options.LandingMarker is { } marker)
                _landingMarker = new LandingMarkerFinder(marker, _options.Camera!, _options.Mount);
        }

        _poseQueue = Receive<PoseSample>(MessageNames.Poses, PosesQueued, QueueFullMode.DropOldest);
        _command = Subscribe<ImagingCommand>(MessageNames.ImagingCommand, wakeOnPost: true);
        _ownAddress = Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _observations = Send<CameraObservation>(MessageNames.CameraObservations);
        _searchedGround = Send<CameraObservation>(MessageNames.SearchedGround);
        _status = Publish<ImagingStatus>(MessageNames.Imaging);
        _landingTarget = Publish<LandingTargetObservation>(MessageNames.LandingTarget);
        _waiting = new WaitingFrames(_options.FramesWaiting);
        _imageChips = new ImageChipBuffer(_options.MaxImageChips, _options.ImageChipSide);
        _overviews = new PictureOverviewBuffer(_options.MaxPictureOverviews, _options.PictureOverviewWidth);
        WakeUpDelay = IdlePeriod;
    }

    /// <summary>
    /// Parts of pictures around the newest reports, oldest first: a snapshot. Any thread, at any time.
    /// </summary>
    public IReadOnlyList<ImageChip> ImageChips => _imageChips.Kept;

    /// <summary>
    /// A whole picture in which something was reported, scaled down; null where it is no longer kept. Any thread, at
    /// any time.
    /// </summary>
    /// <param name="pictureNumber">As <see cref="TargetReport.PictureNumber"/>.</param>
    public PictureOverview? FindPictureOverview(long pictureNumber) => _overviews.Find(pictureNumber);

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;
        _command.Fetch();
        _ownAddress.Fetch();
        while (_poseQueue.TryPop(out PoseSample sample))
            _poses.Add(sample);
        TakeFrames(now);
        if (!IsSearching)
            StopSearch();
        if (UsesPictures)
            SearchWaiting(now);
        PostStatus(now);
        WakeUpDelay = NextWakeUp(now);
    }

    /// <inheritdoc/>
    protected override void Startup() => _source?.LogTo(Log);

    /// <inheritdoc/>
    protected override void Shutdown()
    {
        _waiting.Clear();
        _source?.LogTo(null);
    }

    private bool IsSearching => _command.Value.Mode == ImagingMode.Search;

    // The landing marker is looked for in any mode: vehicles also land without a mission.
    private bool UsesPictures => IsSearching || _landingMarker is not null;

    private void TakeFrames(TimeSpan now)
    {
        if (_camera is null)
            return;
        while (_camera.TryPop(out CameraFrame frame))
        {
            _next.Frames++;
            _next.LastFrameTime = now;
            bool isNew = _numbers.Take(frame.Number, _camera.Counters.Dropped);
            if (!UsesPictures)
            {
                frame.Dispose();
                continue;
            }

            if (!isNew)
            {
                frame.Dispose();
                CountRefusal(
                    PictureQuality.RepeatedNumber, PictureQualityText.RefusalOf(PictureQuality.RepeatedNumber));
                continue;
            }

            // Nothing was true later than it arrived: such a pose cannot come in time, and others need the room.
            if (MiddleOf(frame) - now > _options.PoseTimeout + _options.MaxExtrapolation)
            {
                frame.Dispose();
                CountRefusal(PictureQuality.NoPose, InTheFuture);
                continue;
            }

            if (_waiting.IsFull)
                Refuse(0, NoRoom);
            if (!frame.Pixels.IsEmpty)
                frame.Pixels = frame.Pixels.HandTo(ManagerName);
            _waiting.Add(frame, now);
        }
    }

    // A waiting picture is searched when its pose arrives, which wakes this manager, or refused when it has waited long
    // enough.
    private TimeSpan NextWakeUp(TimeSpan now)
    {
        TimeSpan delay = IdlePeriod;
        for (int i = 0; i < _waiting.Count; i++)
        {
            TimeSpan left = _waiting.Since(i) + _options.PoseTimeout - now;
            delay = left < delay ? left : delay;
        }

        return delay;
    }

    private void SearchWaiting(TimeSpan now)
    {
        for (int i = 0; i < _waiting.Count;)
        {
            PoseLookup answer = FindPoses(_waiting[i], out Pose pose);
            if (answer == PoseLookup.Known)
                Use(i, pose);
            else if (answer != PoseLookup.NotYet)
                Refuse(i, answer == PoseLookup.Gap ? PoseGap : PoseTooOld);
            else if (now - _waiting.Since(i) < _options.PoseTimeout)
                i++;
            else if (_poses.Extrapolate(MiddleOf(_waiting[i]), _options.MaxExtrapolation, out pose)
                == PoseLookup.Extrapolated)
                Use(i, pose);
            else
                Refuse(i, _poses.IsGimbalSilent(MiddleOf(_waiting[i])) ? GimbalSilent : NoPose);
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

    private void Use(int index, in Pose pose)
    {
        // Given back in any case, also after an exception.
        using CameraFrame frame = _waiting.TakeOut(index);
        FindLandingMarker(frame, pose);
        if (IsSearching)
            Search(frame, pose);
    }

    private void FindLandingMarker(in CameraFrame frame, in Pose pose)
    {
        if (_landingMarker is null)
            return;
        ImagingCommand? command = _command.Stamp.Version == 0 ? null : _command.Value;
        if (_landingMarker.TryFind(frame, pose, command, out LandingTargetObservation target, out string? refusal))
        {
            _landingTarget.PostStamped(target, target.Time);
            _next.LandingMarkersFound++;
        }
        else if (refusal is not null)
        {
            _next.LandingMarkersRefused++;
            _next.LastLandingMarkerRefusal = refusal;
        }
    }

    private void Search(in CameraFrame frame, in Pose pose)
    {
        string? refusal = _search!.Search(frame, pose, _command.Value, _ownAddress.Value.SystemId);
        _next.GroundSamplingMetres = _search.View.GroundSamplingMetres;
        _next.LastPicture = _search.Facts;
        if (refusal is not null)
        {
            CountRefusal(_search.Quality, refusal, _search.IsByTilt);
            return;
        }

        Count(PictureQuality.Usable);
        ref readonly CameraObservation observation = ref _search.Observation;
        _next.Observations++;
        _next.ReportsDropped += _search.Dropped;
        foreach (TargetReport report in observation.Reports)
            _imageChips.Add(
                report.PictureNumber, report.Index, frame.Pixels.Array, frame.Width, frame.Height, report.CentreX,
                report.CentreY);
        _overviews.Add(observation, frame.Pixels.Array, frame.Width, frame.Height);
        _next.LastObservation = observation;
        if (_observations.Push(observation) == PushResult.Rejected)
            _next.ReportsDropped += observation.Reports.Length;
        else
            _next.Reports += observation.Reports.Length;

        // What finds no room is in the counters of the queue.
        _ = _searchedGround.Push(observation);
    }

    private void Refuse(int index, string why)
    {
        _waiting.TakeOut(index).Dispose();
        CountRefusal(PictureQuality.NoPose, why);
    }

    private void CountRefusal(PictureQuality quality, string why, bool isByTilt = false)
    {
        _next.FramesRefused++;
        _next.LastRefusal = why;
        Count(quality, isByTilt);
    }

    // Of the search alone: it is judged by them.
    private void Count(PictureQuality quality, bool isByTilt = false)
    {
        if (!IsSearching)
            return;
        PictureCounts counts = _next.Pictures;
        counts.Count(quality);
        _next.Pictures = counts;
        _window.Add(quality, Now, isByTilt);
    }

    // What was seen before says nothing of the next search.
    private void StopSearch()
    {
        if (!UsesPictures)
            _waiting.Clear();
        _window.Clear();
    }

    // At once when the command or the camera changed or a picture was judged, else at least once a second.
    private void PostStatus(TimeSpan now)
    {
        _next.HasCamera = _camera is not null;
        _next.Mode = _command.Value.Mode;
        _next.FramesDropped = _numbers.Lost;
        _next.HasEnded = _camera?.State is DeviceState.Ended or DeviceState.Faulted;
        if (!_next.HasEnded)
            _next.Fault = _source?.Statistics.Fault;
        else if (_camera?.Fault is { } fault)
            _next.Fault ??= $"{fault.GetType().Name}: {fault.Message}";
        _window.Update(now);
        (_next.UsableShare, _next.UnusableCause, _next.UnusableCauseShare) =
            (_window.UsableShare, _window.MainCause, _window.CauseShare);
        ref ImagingStatus posted = ref _status.Value;
        bool isNews = _lastPost is null || posted.Mode != _next.Mode || posted.HasEnded != _next.HasEnded
            || !ReferenceEquals(posted.Fault, _next.Fault)
            || posted.Observations != _next.Observations || posted.FramesRefused != _next.FramesRefused;
        if (_search is not null)
            ReadDetector(_search);
        if (!isNews && now - _lastPost < StatusPeriod)
            return;
        posted = _next;
        _status.Post();
        _lastPost = now;
    }

    private void ReadDetector(PictureSearch search)
    {
        _next.DetectorFailures = search.Detector.Failures;
        _next.DetectionsRefused = search.Detector.Refused;
        _next.DetectorOverruns = search.Detector.Overruns;
        _next.LastDetectorFault = search.Detector.LastFault;
        _next.UnknownClasses = search.UnknownClasses;
        if (search.Detector.LastFault is { } fault)
            LogDetectorFault(fault);
    }

    // Each text once in a row, and no more than one a second: a detector may fail at every picture.
    private void LogDetectorFault(string fault)
    {
        if (string.Equals(fault, _loggedFault, StringComparison.Ordinal) || Now < _nextFaultLog)
            return;
        (_loggedFault, _nextFaultLog) = (fault, Now + TimeSpan.FromSeconds(1));
        Log(fault);
    }
}
