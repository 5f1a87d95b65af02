using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace VisionBench;

/// <summary>The command line.</summary>
internal sealed class BenchOptions
{
    private int _repeats = 1;

    public List<string> Folders { get; } = [];

    public string Part { get; private set; } = "all";

    public bool IsColourEnough { get; private set; }

    public bool IsListed { get; private set; }

    public bool IsHelp { get; private set; }

    /// <summary>Where the page for a browser goes; null for none.</summary>
    public string? HtmlFile { get; private set; }

    /// <exception cref="FormatException">An argument is none.</exception>
    public static BenchOptions Parse(string[] args)
    {
        var options = new BenchOptions();
        for (int i = 0; i < args.Length; i++)
        {
            switch (args[i])
            {
                case "--colour-only":
                    options.IsColourEnough = true;
                    break;
                case "--list":
                    options.IsListed = true;
                    break;
                case "--help" or "-h":
                    options.IsHelp = true;
                    break;
                case "--part" when i + 1 < args.Length && args[i + 1] is "all" or "odd" or "even":
                    options.Part = args[++i];
                    break;
                case "--html" when i + 1 < args.Length:
                    options.HtmlFile = PageOf(args[++i]);
                    break;
                case "--repeat" when i + 1 < args.Length && TryCount(args[i + 1], out options._repeats):
                    i++;
                    break;
                default:
                    if (args[i].StartsWith("--", StringComparison.Ordinal))
                        throw new FormatException(
                            $"{args[i]}: it is no argument, or something is missing after it; --help says more");
                    options.Folders.Add(args[i]);
                    break;
            }
        }

        return options;
    }

    /// <summary>What is to be said beside the reference, of which only figures of whole sets are known.</summary>
    public string ReferenceNote => Part == "all" ? "" : "; OpenCV's figures are of all of them";

    public bool Includes(int index) => Part == "all" || (Part == "odd") == (index % 2 == 1);

    public string Describe() => $"{Part} frames" + (IsColourEnough ? ", by colour alone" : "");

    /// <summary>With the detector that Image Processing makes for these classes.</summary>
    public Bench CreateBench(ImmutableArray<TargetClass> classes) => new(
        new ImageProcessingOptions { TargetClasses = classes }.CreateDetector(), classes, IsColourEnough, _repeats);

    /// <summary>Of markers alone.</summary>
    public MarkerBench CreateMarkerBench() => new(_repeats);

    // A page that has the name of a truth or of a picture would take its place.
    private static string PageOf(string file)
        => file.EndsWith(".html", StringComparison.OrdinalIgnoreCase)
            || file.EndsWith(".htm", StringComparison.OrdinalIgnoreCase)
            ? file
            : throw new FormatException($"--html: {file} must end in .html; --help says more");

    private static bool TryCount(string text, out int count)
        => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out count) && count > 0;
}
