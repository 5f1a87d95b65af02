using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.GroundControl;

/// <summary>
/// The best image chip of each confirmed target as a file that ground stations fetch by MAVLink FTP, and
/// CAMERA_IMAGE_CAPTURED for each that is new or better.
/// </summary>
internal sealed class TargetFiles
{
    // An image chip has some kilobytes; what is older stays with Image Processing and in the report.
    private const int MaxFiles = 100;
    private const double DegE7PerDegree = 1e7;

    private readonly Func<long, int, byte[]?> _picture;
    private readonly MavlinkMemoryFiles _files = new();
    private readonly MavlinkFtpServer _server;
    private readonly MavlinkSender _sender;
    private readonly Dictionary<int, (long Picture, int Report)> _best = [];
    private readonly Queue<CameraImageCaptured> _captured = new();
    private int _images;

    /// <param name="sender">Gives the frames their source.</param>
    /// <param name="picture">
    /// The file of an image chip, by the number of its picture and the index of its report; null where it is kept no
    /// more.
    /// </param>
    public TargetFiles(MavlinkSender sender, Func<long, int, byte[]?> picture)
    {
        (_sender, _picture) = (sender, picture);
        _server = new MavlinkFtpServer(sender, _files);
    }

    /// <summary>Takes the pictures that have become better.</summary>
    /// <param name="tracks">The targets.</param>
    /// <param name="vehicle">Where the camera is, to within the time that a picture takes to be searched.</param>
    /// <param name="now">The time.</param>
    public void Update(TrackList tracks, in VehicleState vehicle, TimeSpan now)
    {
        foreach (TargetTrack track in tracks.Tracks)
        {
            (long Picture, int Report) best = (track.BestPictureNumber, track.BestReportIndex);
            bool isKnown = _best.TryGetValue(track.Id, out (long Picture, int Report) known);
            if (track.State != TrackState.Confirmed || best.Picture < 0 || (isKnown && known == best)
                || (!isKnown && _best.Count >= MaxFiles))
                continue;
            _best[track.Id] = best;
            if (_picture(best.Picture, best.Report) is not { } file)
                continue;
            string path = string.Format(CultureInfo.InvariantCulture, "targets/track-{0:000}.png", track.Id);
            _files.Set(path, file);
            _captured.Enqueue(Captured(path, vehicle, now));
        }
    }

    /// <summary>Handles a received frame.</summary>
    public void Handle(in MavlinkFrame frame, TimeSpan now) => _server.Handle(frame, now);

    /// <summary>Takes the next frame to send.</summary>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        if (_captured.Count == 0)
            return _server.TryTakeFrame(now, out frame);
        frame = _sender.Create(_captured.Dequeue());
        return true;
    }

    // Its attitude is not known here.
    private CameraImageCaptured Captured(string path, in VehicleState vehicle, TimeSpan now)
        => new()
        {
            TimeBootMs = unchecked((uint)(now.Ticks / TimeSpan.TicksPerMillisecond)),
            Lat = (int)Math.Round(vehicle.Position.Latitude.Degrees * DegE7PerDegree),
            Lon = (int)Math.Round(vehicle.Position.Longitude.Degrees * DegE7PerDegree),
            Alt = Millimetres(vehicle.Position.AltitudeAmslMetres),
            RelativeAlt = Millimetres(vehicle.HeightAboveHomeMetres),
            ImageIndex = _images++,
            CaptureResult = MavBool.True,
            FileUrl = new Text205(string.Format(
                CultureInfo.InvariantCulture, "mftp://[;comp={0}]{1}", _sender.ComponentId, path)),
            Q = new FloatArray4([float.NaN, float.NaN, float.NaN, float.NaN]),
        };

    private static int Millimetres(double metres)
        => double.IsNaN(metres) ? 0 : (int)Math.Round(Math.Max(-1e6, Math.Min(1e6, metres)) * 1000);
}
