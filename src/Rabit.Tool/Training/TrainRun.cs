using System;
using System.Globalization;
using System.IO;
using System.Threading;
using Rabit.Files;
using Rabit.Vision;

namespace Rabit.Tool.Training;

/// <summary>Reads labels and pictures, trains, and writes the template.</summary>
internal static class TrainRun
{
    // A template without a scale of its own has a pixel of that part of its length.
    private const int PixelsPerLength = 32;

    // Larger than any part of it, so that the bar of the tool is shown.
    private const long Whole = 1L << 40;

    /// <returns>The exit code.</returns>
    /// <exception cref="ToolException">Something cannot be read or used.</exception>
    public static int Run(string labels, string output, TemplateTrainingOptions options, ToolConsole console)
    {
        try
        {
            // Before minutes of training: whether it could be written, and where nothing is lost by that.
            CheckFolder(output);
            CheckNotRead(output, labels);
            var trainer = new TemplateTrainer(options);
            LabelFile file = LabelFile.Load(labels);
            foreach (LabelledPicture picture in file.Pictures)
                CheckNotRead(output, picture.Path);
            double pixel = options.MetresPerPixel ?? options.LengthMetres / PixelsPerLength;
            TemplateTrainingResult result = Train(trainer, file, labels, pixel);
            result.Template.Save(output);
            Report(result, output, console.Output);
            return ToolExitCode.Done;
        }
        catch (Exception e) when (e is PictureException or FormatException or ArgumentException
            or InvalidOperationException)
        {
            throw new ToolException(FirstLine(e.Message), e);
        }
        catch (OperationCanceledException)
        {
            return ToolExitCode.Interrupted;
        }
    }

    private static TemplateTrainingResult Train(
        TemplateTrainer trainer, LabelFile file, string labels, double templateMetresPerPixel)
    {
        using var cancellation = new CancellationTokenSource();
        void Cancel(object? sender, ConsoleCancelEventArgs e)
        {
            e.Cancel = true;
            cancellation.Cancel();
        }

        Console.CancelKeyPress += Cancel;
        try
        {
            using ProgressBar bar = ProgressBar.Start(Whole);
            var reader = new PictureReader();
            foreach (LabelledPicture picture in file.Pictures)
            {
                cancellation.Token.ThrowIfCancellationRequested();
                RgbPicture pixels = reader.Load(picture.Path);
                CheckSize(pixels, picture, labels, templateMetresPerPixel);
                Add(trainer, pixels, picture);
            }

            return trainer.Train(part => bar.Show((long)(part * Whole)), cancellation.Token);
        }
        finally
        {
            Console.CancelKeyPress -= Cancel;
        }
    }

    // It is made smaller until its pixels are those of the template: one must remain.
    private static void CheckSize(
        RgbPicture pixels, LabelledPicture picture, string labels, double templateMetresPerPixel)
    {
        double metres = Math.Min(pixels.Width, pixels.Height) * picture.MetresPerPixel;
        if (metres < templateMetresPerPixel)
            throw new FormatException(FormattableString.Invariant(
                $"{labels}: {picture.Field}.metresPerPixel is {picture.MetresPerPixel}: {pixels.Width} x {pixels.Height} pixels of that size are less than one pixel of the template, {templateMetresPerPixel} m"));
    }

    private static void Add(TemplateTrainer trainer, RgbPicture pixels, LabelledPicture picture)
    {
        try
        {
            trainer.Add(pixels, picture.MetresPerPixel, picture.Boxes, picture.Group);
        }
        catch (ArgumentException e)
        {
            throw new FormatException($"{picture.Path}: {FirstLine(e.Message)}", e);
        }
    }

    private static void Report(TemplateTrainingResult result, string output, TextWriter to)
    {
        to.WriteLine(string.Format(
            CultureInfo.InvariantCulture,
            "{0}: trained with {1} objects of {2} pictures{3}",
            output, result.Objects, result.Pictures,
            result.Ignored == 0 ? "" : $", {result.Ignored} boxes ignored"));
        to.WriteLine(result.Folds == 0
            ? "how well it does is not known: too few objects, or all pictures are of one group"
            : string.Format(
                CultureInfo.InvariantCulture,
                "on pictures left out: {0:0.00} of the objects found, {1:0.00} false alarms a picture, "
                    + "centres {2:0.00} m off",
                result.Recall, result.FalseAlarmsPerPicture, result.Template.SigmaMetres));
    }

    private static void CheckFolder(string output)
    {
        if (output.Length == 0)
            throw new FormatException("--output is empty");
        string? folder = Path.GetDirectoryName(Path.GetFullPath(output));
        if (folder is not null && !Directory.Exists(folder))
            throw new FormatException($"{output}: there is no folder {folder}");
        if (Directory.Exists(output))
            throw new FormatException($"{output}: that is a folder");

        // A pipe would wait for its reader when all the work is done.
        if (SpecialFile.FindKind(output) is { } kind && kind != "a device")
            throw new FormatException($"{output}: it is {kind}, not a file");
    }

    private static void CheckNotRead(string output, string input)
    {
        if (Path.GetFullPath(input).Equals(Path.GetFullPath(output), StringComparison.Ordinal))
            throw new FormatException($"--output would overwrite {input}, which is read");
    }

    // .NET appends the name of a parameter, which is none of the user's.
    private static string FirstLine(string message)
    {
        int end = message.IndexOf(" (Parameter", StringComparison.Ordinal);
        return (end < 0 ? message : message.Substring(0, end)).Split('\n')[0].TrimEnd('\r');
    }
}
