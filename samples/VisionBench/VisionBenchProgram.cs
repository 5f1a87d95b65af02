using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Vision;

namespace VisionBench;

/// <summary>How well a detector finds the targets of picture sets with truth, beside the reference's figures.</summary>
internal static class VisionBenchProgram
{
    private const string Usage = """
        usage: VisionBench FOLDER... [--part all|odd|even] [--colour-only] [--list]
                           [--html FILE] [--repeat N] [--help]

        FOLDER         a set: pictures with a truth.json (format uav-imagery-truth), or pictures of markers alone
                       (format uav-imagery-marker-crops; photos with "files" and their "tags"; a list of
                       pictures with "markers"); its parent may have the baseline.json of the reference; or photos
                       with a manifest.json ("files", see the README), searched for black and white panels of 0.4 m
        --part         only the odd frames (for tuning) or the even ones
        --colour-only  a panel that is taken for a vehicle of its colour is right, as for the reference
        --list         each miss, each centre that is far off and each false alarm, one line each
        --html         a page for a browser: the figures, and each picture with what was found, missed and falsely
                       alarmed
        --repeat       searches each picture so often; the shortest time counts
        --help         this text

        exit code      0: all sets were searched, whatever was found; 2: an argument, a set or a file is wrong
        """;

    private const int BadInput = 2;

    internal static int Run(string[] args, TextWriter output, TextWriter errors, bool isTerminal)
    {
        try
        {
            BenchOptions options = BenchOptions.Parse(args);
            if (options.IsHelp)
            {
                output.WriteLine(Usage);
                return 0;
            }

            if (options.Folders.Count == 0)
                throw new FormatException("no folder is given; --help says more");

            // All of them before the first is searched: a wrong name ends it at once.
            List<(string Folder, MarkerPictureSet? Markers, PictureSet? Set)> sets =
                options.Folders.Select(f => MarkerPictureSet.TryLoad(f) is { } markers
                    ? (f, markers, (PictureSet?)null)
                    : (f, null, PictureSet.Load(f))).ToList();
            using BenchPage? page = options.HtmlFile is { } file ? new BenchPage(file, options.Describe()) : null;
            foreach ((string folder, MarkerPictureSet? markers, PictureSet? set) in sets)
            {
                using var progress = new Progress(errors, isTerminal);
                if (markers is not null)
                    Run(folder, markers, options, page, output, progress);
                else
                    Run(folder, set!, options, page, output, progress);
            }

            return 0;
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or FormatException or PictureException
                or ArgumentException)
        {
            errors.WriteLine(e.Message.Replace("\r", "").Replace('\n', ' '));
            return BadInput;
        }
    }

    private static void Run(
        string folder, PictureSet set, BenchOptions options, BenchPage? page, TextWriter output, Progress progress)
    {
        Baseline? baseline = Baseline.Load(folder);
        Bench bench = options.CreateBench(set.Classes);
        List<FrameScore> scores = bench.Run(set, (done, of) => progress.Show(set.Name, done, of))
            .Where(s => options.Includes(s.Frame.Index)).ToList();
        progress.Clear();
        var score = new SetScore(set.Name, scores);
        string time = FormattableString.Invariant(
            $"time {bench.DetectorTime.TotalMilliseconds / set.Frames.Length:0.00} ms a frame, markers {bench.MarkerTime.TotalMilliseconds / set.Frames.Length:0.00} ms, {options.Part} frames");
        ScoreTable.Write(score, baseline, output);
        if (set.WithoutScale > 0)
            time += $"; {set.WithoutScale} pictures without a scale were not searched";
        if (baseline is not null)
            time += options.ReferenceNote;
        output.WriteLine("  " + time);
        if (options.IsListed)
            ScoreTable.List(scores, output);
        page?.Add(score, baseline, scores, time);
    }

    private static void Run(
        string folder, MarkerPictureSet set, BenchOptions options, BenchPage? page, TextWriter output,
        Progress progress)
    {
        MarkerBaseline? baseline = MarkerBaseline.Load(folder);
        MarkerBench bench = options.CreateMarkerBench();
        List<MarkerScore> scores = bench.Run(set, (done, of) => progress.Show(set.Name, done, of))
            .Where(s => options.Includes(s.Picture.Index)).ToList();
        progress.Clear();
        string title = $"{set.Name}, {scores.Count} pictures of markers";
        List<(string Name, string Value, string Reference)> rows = new MarkerTotals(scores).Rows(baseline).ToList();
        string time = FormattableString.Invariant(
            $"time {bench.Time.TotalMilliseconds / set.Pictures.Length:0.00} ms a picture, {options.Part} pictures");
        if (baseline is not null)
            time += options.ReferenceNote;
        ScoreTable.Write(title, rows, baseline is not null, output);
        output.WriteLine("  " + time);
        foreach (MarkerScore score in options.IsListed ? scores : [])
            ScoreTable.List(score, output);
        page?.Add(title, rows, baseline is not null, scores, time);
    }

    private static int Main(string[] args)
        => Run(args, Console.Out, Console.Error, !Console.IsErrorRedirected);
}
