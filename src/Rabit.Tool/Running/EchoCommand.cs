using System;
using System.CommandLine;
using System.CommandLine.Completions;
using System.Linq;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Tool.Running;

/// <summary>rabit echo: the values of a message as lines of JSON.</summary>
internal static class EchoCommand
{
    private const int DefaultMilliseconds = 100;
    private const int MinMilliseconds = 10;

    public static Command Create()
    {
        var arguments = new RunningArguments();
        Argument<string> message = new("NAME")
        {
            Description = "The message; MANAGER/status for the status of a manager."
        };
        message.CompletionSources.Add(_ => FindNames());
        Option<int> every = RunningArguments.Every(
            "How often it looks for a new value, 10 to 60000 ms; what it did not see is in missedPosts.",
            DefaultMilliseconds, MinMilliseconds);
        Option<int?> count = RunningArguments.Count("Ends after so many values.");
        Option<bool> once = new("--once") { Description = "Writes the value that there is, and ends." };
        Option<string?> reactor = new("--reactor")
        {
            Description = "Where several reactors have the message.",
            HelpName = "NAME"
        };
        var command = new Command("echo", "Writes the values of a message of a running program as lines of JSON.");
        command.Add(message);
        CommandLine.CheckFileName(message, command);
        foreach (Option option in new Option[] { every, count, once, reactor })
            command.Add(option);
        arguments.AddTo(command);

        // The list of programs needs no name.
        message.Arity = ArgumentArity.ZeroOrOne;
        command.SetAction(result => arguments.Run(result, choice =>
        {
            if (result.GetValue(message) is not { } name)
                throw new ToolException("The name of a message is missing; rabit top shows them.");
            return Write(
                choice,
                new RequestLine
                {
                    Request = RequestLine.Echo,
                    Message = name,
                    Reactor = result.GetValue(reactor),
                    EveryMilliseconds = result.GetValue(once) ? null : result.GetValue(every),
                },
                result.GetValue(once) ? 1 : result.GetValue(count));
        }));
        return command;
    }

    private static int Write(RunningChoice choice, RequestLine request, int? count)
    {
        using DiagnosticsClient client = choice.Connect();
        client.Ask(request);
        for (int written = 0; count is null || written < count; written++)
        {
            Console.WriteLine(PlainText.Of(client.Read("value")));
            client.AllowSilence();
        }

        return ToolExitCode.Done;
    }

    // For the completion of a shell: where one program runs, its messages.
    private static CompletionItem[] FindNames()
    {
        try
        {
            using DiagnosticsClient client = new RunningChoice(null, null).Connect();
            client.Ask(new RequestLine { Request = RequestLine.Status });
            return client.Read("status", ProtocolJson.Default.SampleLine).Reactors
                .SelectMany(r => r.Messages).Select(m => new CompletionItem(m.Name)).ToArray();
        }
        catch (RunningException)
        {
            return [];
        }
    }
}
