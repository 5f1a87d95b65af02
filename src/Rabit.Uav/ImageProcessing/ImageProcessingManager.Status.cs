using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

// What it reports of its work.
public sealed partial class ImageProcessingManager
{
    private void CountRefusal(PictureQuality quality, string why, bool isByManoeuvre = false)
    {
        _next.FramesRefused++;
        _next.LastRefusal = why;
        Count(quality, isByManoeuvre);
    }

    // Of the search alone: it is judged by them.
    private void Count(PictureQuality quality, bool isByManoeuvre = false)
    {
        if (IsSearching)
            _tally.Add(quality, Now, isByManoeuvre);
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
        _tally.ReadInto(ref _next, now);
        _kept?.LogFault(Log);
        ref ImagingStatus posted = ref _status.Value;
        bool isNews = _lastPost is null || posted.Mode != _next.Mode || posted.HasEnded != _next.HasEnded
            || !ReferenceEquals(posted.Fault, _next.Fault)
            || posted.Observations != _next.Observations || posted.FramesRefused != _next.FramesRefused;
        _detector?.ReadInto(ref _next, Now);
        if (!isNews && now - _lastPost < StatusPeriod)
            return;
        posted = _next;
        _status.Post();
        _lastPost = now;
    }
}
