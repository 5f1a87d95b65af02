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

        FOLDER         a set: pictures with a truth.json (format uav-imagery-truth); its parent may have the
                       baseline.json of the reference
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
            List<(string Folder, PictureSet Set)> sets =
                options.Folders.Select(f => (f, PictureSet.Load(f))).ToList();
            using BenchPage? page = options.HtmlFile is { } file ? new BenchPage(file, options.Describe()) : null;
            foreach ((string folder, PictureSet set) in sets)
            {
                using var progress = new Progress(errors, isTerminal);
                Run(folder, set, options, page, output, progress);
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
        Bench bench = options.CreateBench();
        List<FrameScore> scores = bench.Run(set, (done, of) => progress.Show(set.Name, done, of))
            .Where(s => options.Includes(s.Frame.Index)).ToList();
        progress.Clear();
        var score = new SetScore(set.Name, scores);
        Baseline? baseline = Baseline.Load(folder);
        string time = FormattableString.Invariant(
            $"time {bench.DetectorTime.TotalMilliseconds / set.Frames.Length:0.00} ms a frame, {options.Part} frames");
        ScoreTable.Write(score, baseline, output);
        output.WriteLine("  " + time);
        if (options.IsListed)
            ScoreTable.List(scores, output);
        page?.Add(score, baseline, scores, time);
    }

    private static int Main(string[] args)
        => Run(args, Console.Out, Console.Error, !Console.IsErrorRedirected);
}
