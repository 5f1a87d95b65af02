using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Completions;
using System.Linq;

namespace Rabit.Tool.Running;

/// <summary>What the commands have in common that look into a running program: which one.</summary>
internal sealed class RunningArguments
{
    private const int MaxMilliseconds = 60_000;

    private readonly Option<string?> _program = new("--program", "-p")
    {
        Description = "Which program, by its name or the number of its process; needed where several run.",
        HelpName = "NAME|PID",
    };

    private readonly Option<string?> _folder = new("--folder")
    {
        Description = "Where its socket is, where that is not $XDG_RUNTIME_DIR/rabit or /tmp/rabit-UID.",
        HelpName = "DIR",
    };

    private readonly Option<bool> _list = new("--list", "-l")
    {
        Description = "Lists the programs that can be looked into: name, process, socket.",
    };

    public RunningArguments()
        => _program.CompletionSources.Add(_ => RunningPrograms.Find(null).Select(p => new CompletionItem(p.Name)));

    /// <summary>How often.</summary>
    public static Option<int> Every(string description, int defaultMilliseconds, int minMilliseconds)
    {
        Option<int> every = new("--every")
        {
            Description = description,
            HelpName = "MS",
            DefaultValueFactory = _ => defaultMilliseconds,
        };
        every.Validators.Add(r =>
        {
            if (r.Errors.Any())
                return;
            int value = r.GetValueOrDefault<int>();
            if (value < minMilliseconds || value > MaxMilliseconds)
                r.AddError(FormattableString.Invariant(
                    $"--every {value}: it must be {minMilliseconds} to {MaxMilliseconds} ms."));
        });
        return every;
    }

    /// <summary>How many.</summary>
    public static Option<int?> Count(string description)
    {
        Option<int?> count = new("--count", "-n") { Description = description, HelpName = "N" };
        count.Validators.Add(r =>
        {
            if (!r.Errors.Any() && r.GetValueOrDefault<int?>() is < 1)
                r.AddError("--count must be 1 or more.");
        });
        return count;
    }

    public void AddTo(Command command)
    {
        command.Add(_program);
        command.Add(_list);
        command.Add(_folder);
    }

    /// <summary>Runs a command on the program that is meant, or lists the programs.</summary>
    /// <returns>The exit code.</returns>
    public int Run(ParseResult result, Func<RunningChoice, int> run)
    {
        var choice = new RunningChoice(result.GetValue(_folder), result.GetValue(_program));
        try
        {
            return result.GetValue(_list) ? List(choice) : run(choice);
        }
        catch (RunningException e)
        {
            result.InvocationConfiguration.Error.WriteLine(
                $"rabit {result.CommandResult.Command.Name}: {PlainText.Of(e.Message)}");
            return e.ExitCode;
        }
    }

    private static int List(RunningChoice choice)
    {
        IReadOnlyList<RunningProgram> all = RunningPrograms.Find(choice.Folder);
        foreach (RunningProgram program in all)
            Console.WriteLine(FormattableString.Invariant($"{program.Name} {program.ProcessId} {program.Path}"));
        return all.Count > 0
            ? ToolExitCode.Done
            : throw new RunningException(
                $"No program offers diagnostics in {string.Join(" or ", RunningPrograms.FoldersOf(choice.Folder))}.",
                ToolExitCode.NotFound);
    }
}
