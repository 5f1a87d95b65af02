using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Rabit.Latency;

/// <summary>What the user asked for.</summary>
internal sealed class CommandLine
{
    private const string Usage = """
        Rabit.Latency [MODE ...] [options]: measures Rabit beside peers and limits, in the same run.

        Modes: MODES; all (the default) is all but soak.
          --quick          a few seconds: shows that every mode works, and checks no figure
          --rounds N       interleaved rounds (default 7)
          --minutes N      how long the soak lasts (default 1)
          --plant-leak     the soak leaves something behind on purpose, and must fail
          --json FILE      every round's figures for programs
          --into FILE      the tables into a document in Markdown, between its marks
        The exit code is 0 when all required figures were met (quick: when everything worked), 1 when not, 2 for wrong use.
        """;

    private CommandLine(IReadOnlyCollection<string> modes, RunOptions options, string? jsonFile, string? document)
    {
        Modes = modes;
        Options = options;
        JsonFile = jsonFile;
        Document = document;
    }

    public IReadOnlyCollection<string> Modes { get; }

    public RunOptions Options { get; }

    public string? JsonFile { get; }

    public string? Document { get; }

    /// <exception cref="FormatException">There is something that we do not know; the text is the usage.</exception>
    public static CommandLine Parse(string[] arguments, IReadOnlyList<string> known)
    {
        var modes = new HashSet<string>(StringComparer.Ordinal);
        var values = new Dictionary<string, string>(StringComparer.Ordinal);
        for (int i = 0; i < arguments.Length; i++)
        {
            string word = arguments[i];
            if (word is "--quick" or "--plant-leak")
                values[word] = string.Empty;
            else if (word is "--rounds" or "--minutes" or "--json" or "--into" && i + 1 < arguments.Length)
                values[word] = arguments[++i];
            else if (string.Equals(word, "all", StringComparison.Ordinal))
                AddAll(modes, known);
            else if (IsOneOf(known, word))
                modes.Add(word);
            else
                throw new FormatException(
                    $"'{word}' is not known.\n\n" + Usage.Replace("MODES", string.Join(", ", known)));
        }

        if (modes.Count == 0)
            AddAll(modes, known);
        var options = new RunOptions
        {
            IsQuick = values.ContainsKey("--quick"),
            PlantsLeak = values.ContainsKey("--plant-leak"),
            Rounds = (int)Number(values, "--rounds", 7),
            SoakMinutes = Number(values, "--minutes", 1),
        };
        values.TryGetValue("--json", out string? json);
        values.TryGetValue("--into", out string? document);
        if (document is not null && !File.Exists(document))
            throw new FormatException($"--into is '{document}'; there is no such document.");
        return new CommandLine(modes, options, json, document);
    }

    private static double Number(Dictionary<string, string> values, string name, double otherwise)
    {
        if (!values.TryGetValue(name, out string? text))
            return otherwise;
        if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) || !(number > 0)
            || number > 1e6)
            throw new FormatException($"{name} is '{text}'; it must be a number above zero.");
        return number;
    }

    private static void AddAll(HashSet<string> modes, IReadOnlyList<string> known)
    {
        foreach (string mode in known)
        {
            if (!string.Equals(mode, "soak", StringComparison.Ordinal))
                modes.Add(mode);
        }
    }

    private static bool IsOneOf(IReadOnlyList<string> known, string word)
    {
        foreach (string mode in known)
        {
            if (string.Equals(mode, word, StringComparison.Ordinal))
                return true;
        }

        return false;
    }
}
