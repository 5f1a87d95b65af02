using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>
/// The best picture of each track, kept while the album still has it: the album forgets the oldest, and on a long flight the best one of a
/// track may be long gone at the end. One thread at a time.
/// </summary>
internal sealed class TrackPictures(Func<IReadOnlyList<ImageChip>> album)
{
    private readonly Dictionary<int, ImageChip> _pictures = [];   // by the id of the track
    private readonly Dictionary<int, (long Look, int Report)> _best = [];

    /// <summary>Asks the album only when the best picture of a track has become another one.</summary>
    public void Take(TrackList tracks)
    {
        IReadOnlyList<ImageChip>? cutOuts = null;
        foreach (TargetTrack track in tracks.Tracks)
        {
            (long Look, int Report) best = (track.BestPictureNumber, track.BestReportIndex);
            if (best.Look < 0 || (_best.TryGetValue(track.Id, out (long Look, int Report) known) && known == best))
                continue;
            _best[track.Id] = best;
            cutOuts ??= album();
            if (cutOuts.FirstOrDefault(c => c.PictureNumber == best.Look && c.ReportIndex == best.Report) is { } cutOut)
                _pictures[track.Id] = cutOut;
        }
    }

    /// <summary>Those of all tracks, also of the lost ones.</summary>
    public IReadOnlyList<ImageChip> ToArray() => _pictures.Values.ToArray();
}
