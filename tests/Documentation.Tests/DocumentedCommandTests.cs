using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>The commands that the documents show: the program is there, and it has the options.</summary>
public sealed class DocumentedCommandTests
{
    private static readonly Regex Run = new(
        @"dotnet run (?:-c Release )?--project (samples|benchmarks)/([\w.]+)(?: -- ([^\n`#]*))?", RegexOptions.None,
        TimeSpan.FromSeconds(5));

    private static readonly Regex Published = new(
        @"dotnet \S*/?(UavConsole)\.dll ([^\n`#]*)", RegexOptions.None, TimeSpan.FromSeconds(5));

    // At the beginning of a line of code, behind a prompt, or in backquotes.
    private static readonly Regex Tool = new(
        @"(?:^ *(?:\$ )?|`|\$\()rabit ([a-z]+)\b([^\n`#|>]*)", RegexOptions.Multiline, TimeSpan.FromSeconds(5));

    private static readonly Regex Option = new(@"(?<=^|\s)--[a-z][\w-]*", RegexOptions.None, TimeSpan.FromSeconds(5));

    [Fact]
    public void Commands_OfAllDocuments_NameProgramsAndOptionsThatExist()
    {
        var faults = new List<string>();
        int options = 0;
        foreach (string document in DocumentFiles.All.Where(d => d != "CHANGELOG.md"))
        {
            string text = DocumentFiles.Read(document);
            IEnumerable<(string Folder, string Arguments)> commands = Run.Matches(text)
                .Select(m => ($"{m.Groups[1].Value}/{m.Groups[2].Value}", m.Groups[3].Value))
                .Concat(Published.Matches(text).Select(m => ("samples/" + m.Groups[1].Value, m.Groups[2].Value)));
            foreach ((string folder, string arguments) in commands)
            {
                string full = Path.Combine(Repository.Root, folder);
                if (!Directory.Exists(full))
                {
                    faults.Add($"{document}: there is no {folder}");
                    continue;
                }

                string source = string.Concat(
                    Directory.EnumerateFiles(full, "*.cs", SearchOption.AllDirectories).Select(File.ReadAllText));
                foreach (string option in Option.Matches(arguments).Select(m => m.Value))
                {
                    options++;
                    if (!source.Contains($"\"{option}\"", StringComparison.Ordinal)
                        && !IsOfBenchmarkDotNet(folder, option))
                        faults.Add($"{document}: {folder} has no option {option}");
                }
            }
        }

        Assert.True(faults.Count == 0, string.Join(Environment.NewLine, faults));
        Assert.True(options > 20, $"Only {options} options were found in the documents.");
    }

    [Fact]
    public void CommandsOfTheTool_OfAllDocuments_AreThereWithTheirOptions()
    {
        var faults = new List<string>();
        int commands = 0;
        string folder = Path.Combine(Repository.Root, "src", "Rabit.Tool");
        string source = string.Concat(
            Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories).Select(File.ReadAllText));
        foreach (string document in DocumentFiles.All.Where(d => d != "CHANGELOG.md"))
        {
            foreach (Match command in Tool.Matches(DocumentFiles.Read(document)))
            {
                commands++;
                IEnumerable<string> words = Option.Matches(command.Groups[2].Value).Select(m => m.Value)
                    .Where(o => o != "--help").Append(command.Groups[1].Value);
                faults.AddRange(words.Where(w => !source.Contains($"\"{w}\"", StringComparison.Ordinal))
                    .Select(w => $"{document}: rabit {command.Groups[1].Value} has no {w}"));
            }
        }

        Assert.True(faults.Count == 0, string.Join(Environment.NewLine, faults));
        Assert.True(commands > 20, $"Only {commands} commands of the tool were found in the documents.");
    }

    private static bool IsOfBenchmarkDotNet(string folder, string option)
        => folder.EndsWith("/Rabit.Benchmarks", StringComparison.Ordinal) && option is
            "--filter" or "--job" or "--list" or "--iterationTime" or "--iterationCount" or "--warmupCount";
}
