using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;

namespace VisionBench;

/// <summary>How well a detector finds the targets of picture sets with truth, beside the reference's figures.</summary>
internal static class VisionBenchProgram
{
    private const string Usage = """
        usage: VisionBench FOLDER... [--detector shapes|squares] [--part all|odd|even] [--colour-only] [--list] [--repeat N]

        FOLDER         a set: pictures with a truth.json (format uav-imagery-truth); its parent may have the baseline.json of the reference
        --detector     shapes (ShapeTargetDetector, without this), or squares (ColourTargetDetector, which knows no white)
        --part         only the odd frames (for tuning) or the even ones
        --colour-only  a panel that is taken for a vehicle of its colour is right, as for the reference
        --list         each miss and each false alarm, one line each
        --repeat       searches each picture so often; the shortest time counts
        """;

    internal static int Run(string[] args, TextWriter output, TextWriter errors)
    {
        try
        {
            BenchOptions options = BenchOptions.Parse(args);
            if (options.Folders.Count == 0)
            {
                output.WriteLine(Usage);
                return 1;
            }

            foreach (string folder in options.Folders)
                Run(folder, options, output, errors);
            return 0;
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or FormatException or PictureException
                or ArgumentException)
        {
            errors.WriteLine(e.Message.Replace("\r", "").Replace('\n', ' '));
            return 1;
        }
    }

    private static void Run(string folder, BenchOptions options, TextWriter output, TextWriter errors)
    {
        PictureSet set = PictureSet.Load(folder);
        Bench bench = options.CreateBench();
        List<FrameScore> scores = bench.Run(set, (done, of) => Progress(errors, set.Name, done, of))
            .Where(s => options.Includes(s.Frame.Index)).ToList();
        errors.Write("\r" + new string(' ', 60) + "\r");
        var score = new SetScore(set.Name, scores);
        ScoreTable.Write(score, Baseline.Load(folder), output);
        output.WriteLine(FormattableString.Invariant(
            $"  time {bench.DetectorTime.TotalMilliseconds / set.Frames.Length:0.00} ms a frame, {options.Part} frames"));
        if (options.IsListed)
            ScoreTable.List(scores, output);
    }

    private static void Progress(TextWriter errors, string name, int done, int of)
    {
        if (!Console.IsErrorRedirected)
            errors.Write($"\r{name} [{new string('=', 30 * done / of),-30}] {done} of {of}");
    }

    private static int Main(string[] args) => Run(args, Console.Out, Console.Error);
}
