using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Rabit.Tool.Commands;

namespace Rabit.Tool;

/// <summary>Reads the command line and runs the command. What is wrong with it is one line and exit code 2.</summary>
internal static class CommandLine
{
    private const string UnrecognizedByTheLibrary = "Unrecognized command or argument";
    private const string CommandMissing = "Required command was not provided.";
    private const string HelpHint = " (--help shows the options)";
    private const int MaxGuessedWord = 40;

    // A word that begins with @ is a file's name like any other, not a file with more options.
    private static readonly ParserConfiguration Parsing = new() { ResponseFileTokenReplacer = null };

    /// <summary>All commands, with what they share.</summary>
    public static RootCommand Create()
    {
        var root = new RootCommand(
            "The command line tool of Rabit. Exit codes of all commands: 0 done, 1 the answer is no (nothing found, "
            + "refused), 2 bad input, 130 interrupted by Ctrl-C.");
        foreach (Command command in ToolCommands.Create())
            root.Add(command);

        // /h is how a path begins, here and in completion.
        foreach (Option help in root.Options.Where(o => o.Name == "--help"))
        {
            help.Aliases.Remove("/h");
            help.Aliases.Remove("/?");
        }

        return root;
    }

    /// <returns>The exit code.</returns>
    public static int Run(IReadOnlyList<string> arguments, ToolConsole console)
    {
        try
        {
            RootCommand root = Create();
            if (arguments.Count == 0)
                return ShowHelp(root, console);
            ParseResult parsed = root.Parse(GeolocateCommand.JoinPixel(arguments), Parsing);
            return parsed.Errors.Count > 0
                ? Refuse(parsed.CommandResult.Command, string.Join(" ", Faults(parsed)) + HelpHint, console)
                : Run(parsed, console);
        }
        catch (OutputException e) when (e.IsReaderGone)
        {
            return ToolExitCode.Done;   // "rabit ... | head": the reader has what it wanted
        }
    }

    /// <summary>What the name of a file must not be: empty, or an option that there is not.</summary>
    public static void CheckFileName(Argument argument, Command command) => argument.Validators.Add(result =>
    {
        foreach (string word in result.Tokens.Select(t => t.Value))
        {
            if (word.Length == 0)
                result.AddError($"{argument.Name} is empty.");
            else if (word.StartsWith("--", StringComparison.Ordinal))
                result.AddError(NoOption(word, command));
        }
    });

    private static int Run(ParseResult parsed, ToolConsole console)
    {
        Command command = parsed.CommandResult.Command;
        try
        {
            return parsed.Invoke(console);
        }
        catch (ToolException e)
        {
            return Refuse(command, e.Message, console);
        }
        catch (OutputException e) when (!e.IsReaderGone)
        {
            return Refuse(command, e.Message, console);
        }
    }

    // Nothing was asked for: the help, but as an error.
    private static int ShowHelp(RootCommand root, ToolConsole console)
    {
        root.Parse(["--help"]).Invoke(new InvocationConfiguration { Output = console.Error });
        return ToolExitCode.BadInput;
    }

    private static IEnumerable<string> Faults(ParseResult parsed)
    {
        Command command = parsed.CommandResult.Command;
        foreach (string word in parsed.UnmatchedTokens.Take(command is RootCommand ? 1 : int.MaxValue))
        {
            yield return command is RootCommand && word.Length > 0 && word[0] != '-'
                ? $"'{word}' is no command{Guess(word, command.Subcommands.Select(c => c.Name))}"
                : word.StartsWith("--", StringComparison.Ordinal) ? NoOption(word, command)
                : $"'{word}' is one word too many.";
        }

        foreach (string fault in parsed.Errors.Select(e => e.Message))
        {
            if (parsed.UnmatchedTokens.Count == 0
                || (fault != CommandMissing
                    && !fault.StartsWith(UnrecognizedByTheLibrary, StringComparison.Ordinal)))
                yield return fault;
        }
    }

    private static string NoOption(string word, Command command)
        => $"'{word}' is no option{Guess(word, command.Options.Select(o => o.Name))}";

    private static string Guess(string word, IEnumerable<string> known)
        => word.Length <= MaxGuessedWord ? WordGuess.End(word, known) : ".";

    private static int Refuse(Command command, string fault, ToolConsole console)
    {
        string name = command is RootCommand ? "rabit" : "rabit " + command.Name;
        try
        {
            console.Error.WriteLine($"{name}: {OneLine(fault)}");
        }
        catch (IOException)
        {
            // Standard error is closed too; the exit code remains.
        }

        return ToolExitCode.BadInput;
    }

    /// <summary>A message in one line: names of files are shown as they were typed, but move no cursor.</summary>
    public static string OneLine(string text)
        => string.Concat(text.Replace("\r\n", " ").Select(c => c is '\n' or '\t' ? ' ' : char.IsControl(c) ? '.' : c));
}
