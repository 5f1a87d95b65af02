using System;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.Reporting.Html;

/// <summary>What the camera saw of a target: the best image chips, and the whole picture with its box.</summary>
/// <param name="page">Takes them.</param>
/// <param name="record">Has them.</param>
/// <param name="camera">Whose camera it is, for readers who do not see pictures.</param>
internal sealed class ReportPictures(PageWriter page, FlightRecord record, string camera = "the camera")
{
    // Noise makes most of a PNG: without the lowest bits of its levels it is less than half as large.
    private const int KeptBits = 0xF8;
    private const int MiddleOfTheRest = 4;

    /// <summary>Whether there is the best image chip.</summary>
    public bool HasBest(TargetTrack track) => Find(track.BestPictureNumber, track.BestReportIndex) is not null;

    /// <summary>The best image chip, or that there is none.</summary>
    public void WriteBest(TargetTrack track)
    {
        if (Find(track.BestPictureNumber, track.BestReportIndex) is { } picture)
            WriteChip(track, picture);
        else
            page.Element("span", "no picture", "class", "none");
    }

    /// <summary>Two more, and the whole picture of the best one; nothing where there are none.</summary>
    public void WriteOthers(TargetTrack track)
    {
        ImageChip[] others =
            [.. track.OtherPictures.Select(o => Find(o.PictureNumber, o.ReportIndex)).OfType<ImageChip>()];
        PictureOverview? overview =
            record.Overviews.FirstOrDefault(o => o.PictureNumber == track.BestPictureNumber);
        if (others.Length == 0 && overview is null)
            return;
        page.Open("div", "class", "more").Open("div", "class", "others");
        foreach (ImageChip other in others)
            WriteChip(track, other);
        page.Close();
        if (overview is not null)
            WriteOverview(track, overview);
        page.Close();
    }

    private void WriteChip(TargetTrack track, ImageChip chip) => page.Empty(
        "img", "src", DataUri.Of(new RgbPicture(chip.Width, chip.Height, chip.CopyPixels())), "alt",
        $"What {camera} saw of track {FlightText.Number(track.Id)}, picture {FlightText.Number(chip.PictureNumber)}");

    private void WriteOverview(TargetTrack track, PictureOverview overview)
    {
        byte[] pixels = overview.CopyPixels();
        for (int i = 0; i < pixels.Length; i++)
            pixels[i] = (byte)((pixels[i] & KeptBits) | MiddleOfTheRest);
        page.Open("div", "class", "frame").Empty(
            "img", "src", DataUri.Of(new RgbPicture(overview.Width, overview.Height, pixels)), "alt",
            $"Picture {FlightText.Number(overview.PictureNumber)} of {camera} with track "
                + FlightText.Number(track.Id));
        foreach (PictureBox box in overview.Boxes)
        {
            page.Element(
                "i", string.Empty, "class", box.ReportIndex == track.BestReportIndex ? "box" : "box other", "style",
                $"left:{Percent(box.Left)};top:{Percent(box.Top)};width:{Percent(box.Width)};"
                    + $"height:{Percent(box.Height)}");
        }

        page.Close();
    }

    private ImageChip? Find(long picture, int report)
        => record.Pictures.FirstOrDefault(c => c.PictureNumber == picture && c.ReportIndex == report);

    private static string Percent(double part) => FlightText.Number(100 * part, "0.##") + "%";
}
