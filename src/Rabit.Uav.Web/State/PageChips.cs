using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.Web.State;

/// <summary>
/// The best picture of each track, as PNG. Kept here because those of Image Processing are the newest ones only. The
/// page takes, browsers read.
/// </summary>
internal sealed class PageChips
{
    private readonly Lock _gate = new();   // guards all below
    private readonly Dictionary<int, Entry> _byTrack = [];
    private long _last;

    /// <summary>Takes over the best picture of a track where it is a new one.</summary>
    /// <returns>Its number, which changes with the picture; 0 where there is none.</returns>
    public long Take(TargetTrack track, IReadOnlyList<ImageChip> chips)
    {
        Entry? known = Find(track.Id);
        if (known is not null && known.Picture == track.BestPictureNumber && known.Report == track.BestReportIndex)
            return known.Number;
        if (track.BestPictureNumber < 0 || FindChip(track, chips) is not { } chip)
            return known?.Number ?? 0;
        byte[] png = PngPicture.Encode(new RgbPicture(chip.Width, chip.Height, chip.CopyPixels()));
        lock (_gate)
        {
            _byTrack[track.Id] = new Entry(++_last, track.BestPictureNumber, track.BestReportIndex, png);
            return _last;
        }
    }

    public void Forget(int track)
    {
        lock (_gate)
            _byTrack.Remove(track);
    }

    /// <returns>PNG; null where there is none.</returns>
    public byte[]? Read(int track) => Find(track)?.Png;

    private Entry? Find(int track)
    {
        lock (_gate)
            return _byTrack.GetValueOrDefault(track);
    }

    private static ImageChip? FindChip(TargetTrack track, IReadOnlyList<ImageChip> chips)
    {
        foreach (ImageChip chip in chips)
        {
            if (chip.PictureNumber == track.BestPictureNumber && chip.ReportIndex == track.BestReportIndex)
                return chip;
        }

        return null;
    }

    private sealed record Entry(long Number, long Picture, int Report, byte[] Png);
}
