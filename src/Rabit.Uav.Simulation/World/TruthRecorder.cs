using System;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Keeps what the vehicle has really done. Written by the vehicle step by step, read by any thread, under a lock.
/// </summary>
internal sealed class TruthRecorder
{
    private const double CrashSpeed = 2;
    private static readonly TimeSpan PathEvery = TimeSpan.FromMilliseconds(200);

    private readonly object _gate = new();

    // All below is under _gate.
    private TruePose[] _path = new TruePose[256];   // what is below the count never changes: snapshots share it
    private int _pathCount;
    private TruePose _pose;
    private TruePose? _landing;
    private TimeSpan _nextPath;
    private TimeSpan _airtime;
    private double _touchdown;
    private double _battery = 1;
    private double _flown;
    private double _height;
    private double _speed;
    private double _distance;
    private bool _isArmed;
    private bool _isAirborne;
    private bool _hasFlown;
    private bool _hasCrashed;
    private uint _mode;
    private string _modeName = string.Empty;
    private long _sent;
    private long _received;
    private long _lost;

    public void Record(
        in TruePose pose, bool isArmed, uint mode, string modeName, double battery, double touchdownSpeed)
    {
        lock (_gate)
        {
            Move(pose, touchdownSpeed);
            _isArmed = isArmed;
            _mode = mode;
            _modeName = modeName;
            _battery = battery;
            if (_pathCount == 0 || ((isArmed || _isAirborne) && pose.Time >= _nextPath))
                AddToPath(pose);
        }
    }

    public void CountFrames(long sent, long received, long lost)
    {
        lock (_gate)
            (_sent, _received, _lost) = (sent, received, lost);
    }

    public SimulatedTruth Snapshot()
    {
        lock (_gate)
        {
            return new SimulatedTruth
            {
                Pose = _pose,
                Path = new ArraySegment<TruePose>(_path, 0, _pathCount),
                IsArmed = _isArmed,
                IsAirborne = _isAirborne,
                HasFlown = _hasFlown,
                Landing = _landing,
                TouchdownMetresPerSecond = _touchdown,
                HasCrashed = _hasCrashed,
                CustomMode = _mode,
                Mode = _modeName,
                BatteryRemaining = _battery,
                Airtime = _airtime,
                FlownMetres = _flown,
                MaxHeightMetres = _height,
                MaxSpeedMetresPerSecond = _speed,
                MaxDistanceMetres = _distance,
                FramesSent = _sent,
                FramesReceived = _received,
                FramesLost = _lost,
            };
        }
    }

    private void AddToPath(in TruePose pose)
    {
        if (_pathCount == _path.Length)
            Array.Resize(ref _path, 2 * _path.Length);
        _path[_pathCount++] = pose;
        _nextPath = pose.Time + PathEvery;
    }

    private void Move(in TruePose pose, double touchdownSpeed)
    {
        bool isAirborne = pose.Position.Down < 0;
        if (isAirborne)
        {
            _hasFlown = true;
            _airtime += pose.Time - _pose.Time;
            _flown += pose.Position.HorizontalDistanceTo(_pose.Position);
            _height = Math.Max(_height, -pose.Position.Down);
            _speed = Math.Max(_speed, pose.VelocityNed.HorizontalLength);
            _distance = Math.Max(_distance, pose.Position.HorizontalDistanceTo(NedPosition.Origin));
        }
        else if (_isAirborne)
        {
            _landing = pose;
            _touchdown = touchdownSpeed;
            _hasCrashed |= touchdownSpeed > CrashSpeed;
        }

        _isAirborne = isAirborne;
        _pose = pose;
    }
}
