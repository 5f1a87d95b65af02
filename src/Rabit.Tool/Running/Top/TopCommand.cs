using System.CommandLine;

namespace Rabit.Tool.Running.Top;

/// <summary>rabit top: managers, queues and messages of a running program, as they change.</summary>
internal static class TopCommand
{
    private const int DefaultMilliseconds = 1000;
    private const int MinMilliseconds = 100;

    public static Command Create()
    {
        var arguments = new RunningArguments();
        Option<int> every = RunningArguments.Every(
            "From one sample to the next, 100 to 60000 ms.", DefaultMilliseconds, MinMilliseconds);
        Option<bool> once = new("--once") { Description = "One sample, taken over --every, as plain lines." };
        Option<int?> count = RunningArguments.Count("So many samples, as plain lines.");
        Option<TopSection> show = new("--show")
        {
            Description = "all, managers, queues or messages.",
            HelpName = "WHAT"
        };
        Option<TopOrder> sort = new("--sort")
        {
            Description = "start (the order of the start), name, rate, load (level of queues, young messages first), "
                + "trouble (missed, lost, old first).",
            HelpName = "BY",
        };
        Option<string?> filter = new("--filter") { Description = "Only names that contain it.", HelpName = "TEXT" };
        var command = new Command(
            "top",
            "Shows what the managers of a running program do, its queues and its messages; on a terminal a table that "
                + "follows, sorted and filtered by keys (the last line has them), otherwise plain lines.");
        foreach (Option option in new Option[] { every, once, count, show, sort, filter })
            command.Add(option);
        arguments.AddTo(command);
        command.SetAction(result => arguments.Run(result, choice => Run(
            choice,
            new TopSettings
            {
                Section = result.GetValue(show),
                Order = result.GetValue(sort),
                Filter = result.GetValue(filter) ?? string.Empty,
            },
            result.GetValue(every),
            result.GetValue(once) ? 1 : result.GetValue(count))));
        return command;
    }

    private static int Run(RunningChoice choice, TopSettings settings, int everyMilliseconds, int? count)
    {
        DiagnosticsClient client = choice.Connect();
        if (count is null && TopScreen.IsPossible())
        {
            using var screen = new TopScreen(settings);
            return screen.Run(choice, client, everyMilliseconds);
        }

        using (client)
            return new TopLines(settings).Run(client, everyMilliseconds, count);
    }
}
