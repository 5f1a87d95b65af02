using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// A mission file that cannot be read, or a mission that cannot be flown. The message names the mission and all faults.
/// </summary>
public sealed class MissionPlanException : Exception
{
    internal MissionPlanException(string name, IEnumerable<string> faults)
        : this(name, faults.ToArray())
    {
    }

    private MissionPlanException(string name, string[] faults)
        : base($"Mission '{name}': {SentenceOf(faults)}")
        => Faults = faults;

    /// <summary>The faults, each with the path of its value.</summary>
    public IReadOnlyList<string> Faults { get; }

    /// <summary>The faults as one sentence.</summary>
    public string Sentence => SentenceOf(Faults);

    // A fault may end with a question: "did you mean ...?"
    private static string SentenceOf(IEnumerable<string> faults)
    {
        string text = string.Join("; ", faults);
        return text.Length > 0 && text[text.Length - 1] == '?' ? text : text + ".";
    }
}
