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
public sealed partial class ImageProcessingManager : RabitManager
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

    // Pictures between two units of work; the newer ones are worth more.
    private const int FramesQueued = 2;

    // Some seconds of poses at 60 a second: more than the longest unit of work of any manager.
    private const int PosesQueued = 1000;

    private readonly ImageProcessingOptions _options;
    private readonly BlockingReader<CameraFrame>? _camera;
    private readonly ICamera? _source;
    private readonly PictureSearch? _search;
    private readonly DetectorFigures? _detector;
    private readonly PicturePoses? _picturePoses;   // with a camera, without which there are no pictures
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
    private readonly PictureDisplays _displays;
    private readonly KeptPictures? _kept;
    private readonly FrameNumbers _numbers = new();
    private readonly PictureTally _tally = new();
    private ImagingStatus _next;
    private TimeSpan? _lastPost;

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
            _detector = new DetectorFigures(_search, Log);
            _picturePoses = new PicturePoses(_options.Camera!, _poses);
            if (_options.KeptPictures is { } kept)
                _kept = MakeKept(kept, _options.Camera!);
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
        _displays = new PictureDisplays(_options);
        WakeUpDelay = IdlePeriod;
    }

    /// <summary>
    /// Parts of pictures around the newest reports, oldest first: a snapshot. Any thread, at any time.
    /// </summary>
    public IReadOnlyList<ImageChip> ImageChips => _displays.Chips;

    /// <summary>
    /// A whole picture in which something was reported, scaled down; null where it is no longer kept. Any thread, at
    /// any time.
    /// </summary>
    /// <param name="pictureNumber">As <see cref="TargetReport.PictureNumber"/>.</param>
    public PictureOverview? FindPictureOverview(long pictureNumber) => _displays.FindOverview(pictureNumber);

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

        // A waiting picture is searched when its pose arrives, which wakes this manager, or refused when it has waited
        // long enough.
        WakeUpDelay = _waiting.DelayUntil(now, _options.PoseTimeout, IdlePeriod);
    }

    /// <inheritdoc/>
    protected override void Startup() => _source?.LogTo(Log);

    /// <inheritdoc/>
    protected override void Shutdown()
    {
        _waiting.Clear();
        _source?.LogTo(null);
    }

    private bool IsSearching => _command.Value.Mode != ImagingMode.Off;

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
            if (_picturePoses!.MiddleOf(frame) - now > _options.PoseTimeout + _options.MaxExtrapolation)
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

    private void SearchWaiting(TimeSpan now)
    {
        for (int i = 0; i < _waiting.Count;)
        {
            PoseLookup answer = _picturePoses!.Find(_waiting[i], out Pose pose);
            if (answer == PoseLookup.Known)
                Use(i, pose);
            else if (answer != PoseLookup.NotYet)
                Refuse(i, answer == PoseLookup.Gap ? PoseGap : PoseTooOld);
            else if (now - _waiting.Since(i) < _options.PoseTimeout)
                i++;
            else if (_poses.Extrapolate(_picturePoses!.MiddleOf(_waiting[i]), _options.MaxExtrapolation, out pose)
                == PoseLookup.Extrapolated)
                Use(i, pose);
            else
                Refuse(i, _poses.IsGimbalSilent(_picturePoses!.MiddleOf(_waiting[i])) ? GimbalSilent : NoPose);
        }
    }

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
            CountRefusal(_search.Quality, refusal, _search.IsByManoeuvre);
            return;
        }

        Count(PictureQuality.Usable);
        ref readonly CameraObservation observation = ref _search.Observation;
        _next.Observations++;
        _next.ReportsDropped += _search.Dropped;
        _displays.Add(observation, frame);
        Keep(frame);
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

    private void StopSearch()
    {
        if (!UsesPictures)
            _waiting.Clear();
        _tally.StartAgain();
    }
}
