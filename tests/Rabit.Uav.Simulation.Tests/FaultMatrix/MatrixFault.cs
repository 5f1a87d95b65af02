using System;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>Something that goes wrong in a flight of the fault matrix.</summary>
/// <param name="Name">For people.</param>
/// <param name="Script">What the simulated world is made to do, by the autopilot and the time of the fault.</param>
internal sealed record MatrixFault(string Name, Func<SimulatedAutopilot, TimeSpan, ScriptedFault[]> Script)
{
    /// <summary>What is done from outside when the time has come; null: nothing.</summary>
    public Action<MatrixFlight>? Action { get; init; }

    /// <summary>Whether the program is stopped at the time, as by Ctrl-C.</summary>
    public bool StopsProgram { get; init; }

    /// <summary>Whether a manager of the user throws at the time.</summary>
    public bool Throws { get; init; }

    /// <summary>A fault of the simulated world that is the same for both autopilots.</summary>
    public static MatrixFault Of(string name, ScriptedFaultKind kind, double value = 0, double seconds = 0)
        => new(name, (_, at) =>
        [
            new ScriptedFault { Kind = kind, At = at, Value = value, Duration = TimeSpan.FromSeconds(seconds) },
        ]);

    /// <summary>A mode that the pilot takes.</summary>
    public static MatrixFault Pilot(string name, string ardupilot, string px4, bool bySwitch = false)
        => new(name, (model, at) =>
        [
            new ScriptedFault
            {
                Kind = ScriptedFaultKind.PilotMode, At = at, BySwitch = bySwitch,
                Mode = model == SimulatedAutopilot.Px4 ? px4 : ardupilot,
            },
        ]);

    /// <summary>A manager that hangs.</summary>
    public static MatrixFault Hang(string manager, double seconds = 20)
        => new(FormattableString.Invariant($"{manager} hangs {seconds} s"), (_, at) =>
        [
            new ScriptedFault
            {
                Kind = ScriptedFaultKind.ManagerHangs, At = at, Manager = manager,
                Duration = TimeSpan.FromSeconds(seconds),
            },
        ]);

    /// <summary>Something that is done from outside.</summary>
    public static MatrixFault Outside(string name, Action<MatrixFlight>? action)
        => new(name, (_, _) => []) { Action = action };
}
