namespace Rabit.Core;

/// <summary>The three things a manager does.</summary>
public enum ManagerStage
{
    /// <summary><see cref="RabitManager.Startup"/>.</summary>
    Startup,

    /// <summary><see cref="RabitManager.ExecuteUnitOfWork"/>.</summary>
    UnitOfWork,

    /// <summary><see cref="RabitManager.Shutdown"/>.</summary>
    Shutdown,
}
