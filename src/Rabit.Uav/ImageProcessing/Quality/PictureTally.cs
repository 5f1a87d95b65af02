using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>What became of the pictures of the search, in all and lately. One thread.</summary>
internal sealed class PictureTally
{
    // Three pictures at 2 Hz, or four where they come more slowly: one or two that are bad are no fault of the camera.
    private static readonly TimeSpan Window = TimeSpan.OfSeconds(1.5);
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    private readonly PictureWindow _window = new(Window, MaxAge);
    private PictureCounts _counts;

    /// <summary>Counts one.</summary>
    public void Add(PictureQuality quality, TimeSpan now, bool isByManoeuvre)
    {
        _counts.Count(quality);
        _window.Add(quality, now, isByManoeuvre);
    }

    /// <summary>Forgets what was lately: it says nothing of the next search.</summary>
    public void StartAgain() => _window.Clear();

    /// <summary>Copies it.</summary>
    public void ReadInto(ref ImagingStatus status, TimeSpan now)
    {
        _window.Update(now);
        status.Pictures = _counts;
        (status.UsableShare, status.UnusableCause, status.UnusableCauseShare) =
            (_window.UsableShare, _window.MainCause, _window.CauseShare);
    }
}
