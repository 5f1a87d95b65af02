using System;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using Rabit.Tool.Training;
using Rabit.Vision;

namespace Rabit.Tool.Commands;

/// <summary><c>rabit train</c>: a template for the template detector, from labelled pictures.</summary>
internal static class TrainCommand
{
    private const double MinMetres = 0.01;
    private const double MaxMetres = 100;
    private const double MinMetresPerPixel = 0.000_01;
    private const double MinAlarms = 0.000_001;
    private const double MaxAlarms = 1000;

    public static Command Create()
    {
        var defaults = new TemplateTrainingOptions();
        var labels = new Argument<string>("LABELS")
        {
            Description = "The labelled pictures (JSON, docs/template-file.md): each with file, metresPerPixel, boxes.",
        };
        var output = new Option<string>("--output", "-o")
        {
            Description = "Where the template goes; a file that there is, is replaced.",
            HelpName = "FILE",
            Required = true,
        };
        var name = new Option<string>("--name")
        {
            Description = "What the template is called.",
            HelpName = "NAME",
            DefaultValueFactory = _ => defaults.Name,
        };
        Option<double> length = NumberOption(
            "--length", "METRES", "Length of the usual object.", defaults.LengthMetres);
        Option<double> width = NumberOption("--width", "METRES", "Width of the usual object.", defaults.WidthMetres);
        CheckRange(length, MinMetres, MaxMetres);
        CheckRange(width, MinMetres, MaxMetres);
        var pixel = new Option<double?>("--metres-per-pixel")
        {
            Description = "How fine pictures are searched; without it a 32nd of the length.",
            HelpName = "METRES",
        };
        Option<double> alarms = NumberOption(
            "--false-alarms", "N", "How many false alarms a picture may have: sets the threshold.",
            defaults.FalseAlarmsPerPicture);
        CheckRange(pixel, MinMetresPerPixel, MaxMetres);
        CheckRange(alarms, MinAlarms, MaxAlarms);
        var command = new Command(
            "train",
            "Trains a template from labelled pictures, and says how well it does on pictures that were left out. The "
                + "detector for classes with a template finds such objects from above, at any heading.")
        {
            labels, output, name, length, width, pixel, alarms,
        };
        CommandLine.CheckFileName(labels, command);
        command.SetAction(result =>
        {
            var options = new TemplateTrainingOptions
            {
                Name = result.GetValue(name)!,
                LengthMetres = result.GetValue(length),
                WidthMetres = result.GetValue(width),
                MetresPerPixel = result.GetValue(pixel),
                FalseAlarmsPerPicture = result.GetValue(alarms),
            };
            var console = (ToolConsole)result.InvocationConfiguration;
            return TrainRun.Run(result.GetValue(labels)!, result.GetValue(output)!, options, console);
        });
        return command;
    }

    // What does not go together, as a pixel larger than the object, is found by the training.
    private static void CheckRange<T>(Option<T> option, double min, double max) => option.Validators.Add(result =>
    {
        // What is no number has an error already.
        foreach (string word in result.Tokens.Select(t => t.Value))
        {
            if (double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
                && !(value >= min && value <= max))
                result.AddError(FormattableString.Invariant($"{option.Name} is {word}; it must be {min} to {max}."));
        }
    });

    private static Option<double> NumberOption(string name, string unit, string description, double value)
        => new(name) { Description = description, HelpName = unit, DefaultValueFactory = _ => value };
}
