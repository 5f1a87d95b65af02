using System;
using System.CommandLine;
using System.IO;

namespace Rabit.Tool.Commands;

/// <summary><c>rabit completion</c>: a script with which a shell completes commands, options and values.</summary>
internal static class CompletionCommand
{
    private static readonly string[] Shells = ["bash", "zsh", "fish"];

    public static Command Create()
    {
        var shell = new Argument<string>("SHELL") { Description = "bash, zsh or fish." };
        shell.CompletionSources.Add(Shells);
        shell.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && Array.IndexOf(Shells, result.Tokens[0].Value) < 0)
                result.AddError($"'{result.Tokens[0].Value}' is no shell that has completion; there are "
                    + string.Join(", ", Shells) + ".");
        });
        var command = new Command(
            "completion",
            "Prints a script with which a shell completes commands, options and values: its first lines say where it "
                + "goes.")
        {
            shell,
        };
        command.SetAction(result => result.InvocationConfiguration.Output.Write(Script(result.GetValue(shell)!)));
        return command;
    }

    private static string Script(string shell)
    {
        using Stream script = typeof(CompletionCommand).Assembly
            .GetManifestResourceStream($"Rabit.Tool.Completion.rabit.{shell}")!;
        using var reader = new StreamReader(script);
        return reader.ReadToEnd();
    }
}
