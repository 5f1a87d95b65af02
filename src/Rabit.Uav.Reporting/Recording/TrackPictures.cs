using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// The best picture of each track, kept while the manager still has it: the manager forgets the oldest, and on a long
/// flight the best one of a track may be long gone at the end. One thread at a time.
/// </summary>
internal sealed class TrackPictures(Func<IReadOnlyList<ImageChip>> imageChips)
{
    private readonly Dictionary<int, ImageChip> _pictures = [];   // by the id of the track
    private readonly Dictionary<int, (long Picture, int Report)> _best = [];

    /// <summary>Asks for the image chips only when the best picture of a track has become another one.</summary>
    public void Take(TrackList tracks)
    {
        IReadOnlyList<ImageChip>? chips = null;
        foreach (TargetTrack track in tracks.Tracks)
        {
            (long Picture, int Report) best = (track.BestPictureNumber, track.BestReportIndex);
            if (best.Picture < 0
                || (_best.TryGetValue(track.Id, out (long Picture, int Report) known) && known == best))
                continue;
            _best[track.Id] = best;
            chips ??= imageChips();
            if (chips.FirstOrDefault(c => c.PictureNumber == best.Picture && c.ReportIndex == best.Report) is { } chip)
                _pictures[track.Id] = chip;
        }
    }

    /// <summary>Those of all tracks, also of the lost ones.</summary>
    public IReadOnlyList<ImageChip> ToArray() => _pictures.Values.ToArray();
}
