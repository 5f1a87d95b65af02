using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Tool.Running;

/// <summary>rabit graph: the wiring of a running program.</summary>
internal static class GraphCommand
{
    public static Command Create()
    {
        var arguments = new RunningArguments();
        Option<string> format = new("--format", "-f")
        {
            Description = "mermaid (the default), dot or text.",
            HelpName = "FORMAT",
            DefaultValueFactory = _ => "mermaid",
        };
        format.AcceptOnlyFromAmong("mermaid", "dot", "text");
        Option<string?> reactor = new("--reactor")
        {
            Description = "One reactor of several; without it all.",
            HelpName = "NAME"
        };
        var command = new Command("graph", "Writes who posts, fetches, pushes and pops what in a running program.");
        command.Add(format);
        command.Add(reactor);
        arguments.AddTo(command);
        command.SetAction(result => arguments.Run(
            result, choice => Write(choice, result.GetValue(format)!, result.GetValue(reactor))));
        return command;
    }

    private static int Write(RunningChoice choice, string format, string? reactor)
    {
        using DiagnosticsClient client = choice.Connect();
        client.Ask(new RequestLine { Request = RequestLine.Graph, Format = format, Reactor = reactor });
        IReadOnlyList<ReactorGraph> graphs = client.Read("graph", ProtocolJson.Default.GraphLine).Reactors;
        if (graphs.FirstOrDefault(g => g.Text.Length == 0) is { } early)
            throw new RunningException($"Reactor '{early.Name}' has not started yet.", ToolExitCode.NotFound);

        // Each is a drawing of its own.
        string comment = format == "dot" ? "// " : "%% ";
        foreach (ReactorGraph graph in graphs)
        {
            if (graphs.Count > 1)
                Console.WriteLine((format == "text" ? string.Empty : comment) + "reactor " + PlainText.Of(graph.Name));
            Console.Write(PlainText.OfLines(graph.Text));
        }

        return ToolExitCode.Done;
    }
}
