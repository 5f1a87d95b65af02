using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Tool.Running;

/// <summary>Finds the programs of this user that can be looked into.</summary>
internal static class RunningPrograms
{
    /// <summary>Where they are.</summary>
    /// <param name="folder">The one that the user names; null for the usual ones.</param>
    public static IReadOnlyList<string> FoldersOf(string? folder)
    {
        if (folder is not null)
            return [folder];
        string? session = DiagnosticsFolder.OfSession(
            Environment.GetEnvironmentVariable(DiagnosticsFolder.Variable));
        string without = DiagnosticsFolder.WithoutSession(PeerUser.Own);
        return session is null ? [without] : [session, without];
    }

    /// <summary>Those that run, by name and number.</summary>
    /// <param name="folder">As for <see cref="FoldersOf"/>.</param>
    public static IReadOnlyList<RunningProgram> Find(string? folder)
        => FoldersOf(folder).SelectMany(FindIn)
            .OrderBy(p => p.Name, StringComparer.Ordinal).ThenBy(p => p.ProcessId).ToArray();

    /// <summary>The one program that is meant.</summary>
    /// <param name="folder">As for <see cref="FoldersOf"/>.</param>
    /// <param name="name">Its name or number; null where there is one alone.</param>
    /// <exception cref="RunningException">There is none, or there are several.</exception>
    public static RunningProgram Choose(string? folder, string? name)
    {
        IReadOnlyList<RunningProgram> all = Find(folder);
        RunningProgram[] found = all.Where(p => name is null || IsCalled(p, name)).ToArray();
        return found.Length switch
        {
            1 => found[0],
            0 when all.Count == 0 => throw new RunningException(
                $"No program offers diagnostics in {string.Join(" or ", FoldersOf(folder))}.", ToolExitCode.NotFound),
            0 => throw new RunningException(
                $"No program '{name}' offers diagnostics; there are: {ListOf(all)}.", ToolExitCode.NotFound),
            _ => throw new RunningException(
                $"Several programs offer diagnostics: {ListOf(found)}; name one by --program NAME or its number.",
                ToolExitCode.BadInput),
        };
    }

    private static string ListOf(IEnumerable<RunningProgram> programs) => string.Join(", ", programs);

    private static bool IsCalled(RunningProgram program, string name)
        => string.Equals(program.Name, name, StringComparison.Ordinal)
            || string.Equals(program.ProcessId.ToString(CultureInfo.InvariantCulture), name, StringComparison.Ordinal);

    // A program that was killed leaves its socket.
    private static IEnumerable<RunningProgram> FindIn(string folder)
    {
        try
        {
            return DiagnosticsFolder.Find(folder)
                .Where(f => Directory.Exists("/proc/" + f.ProcessId.ToString(CultureInfo.InvariantCulture)))
                .Select(f => new RunningProgram(f.Path, f.Program, f.ProcessId)).ToArray();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Another user's.
            return [];
        }
    }
}
