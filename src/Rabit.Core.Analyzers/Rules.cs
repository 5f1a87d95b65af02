using Microsoft.CodeAnalysis;

namespace Rabit.Core.Analyzers;

/// <summary>All rules. Each has a page in docs/analyzers.</summary>
internal static class Rules
{
    private const string Category = "Rabit.Core";

    public static readonly DiagnosticDescriptor AsyncCode = new(
        "RABIT0001", "A manager's code is async",
        "'{0}' of manager '{1}' is async: after its first await it continues on another thread, where no endpoint of "
            + "the manager may be used, and an exception ends the process",
        Category, DiagnosticSeverity.Error, isEnabledByDefault: true, Description(1));

    public static readonly DiagnosticDescriptor BlockingCall = new(
        "RABIT0002", "A unit of work blocks its thread",
        "'{0}' blocks the thread of manager '{1}' in a unit of work, which then neither fetches nor stops; use a "
            + "wake-up, or a reader or writer for a device",
        Category, DiagnosticSeverity.Warning, isEnabledByDefault: true, Description(2));

    public static readonly DiagnosticDescriptor OtherTime = new(
        "RABIT0003", "A manager reads or waits for a time that is not the run's",
        "'{0}' in manager '{1}' does not follow the time of the run, and is wrong in virtual time; use Now or Clock, "
            + "WakeUpDelay or Period",
        Category, DiagnosticSeverity.Warning, isEnabledByDefault: true, Description(3));

    public static readonly DiagnosticDescriptor UnseededRandom = new(
        "RABIT0004", "A manager draws random numbers without a seed",
        "'{0}' in manager '{1}' gives other numbers in each run, so that no run can be repeated; use new Random(seed)",
        Category, DiagnosticSeverity.Warning, isEnabledByDefault: true, Description(4));

    public static readonly DiagnosticDescriptor MutableType = new(
        "RABIT0005", "A message or queue of a type that can be changed",
        "{0} '{1}' lets two managers share what one of them can change: {2}",
        Category, DiagnosticSeverity.Warning, isEnabledByDefault: true, Description(5));

    public static readonly DiagnosticDescriptor IgnoredPushResult = new(
        "RABIT0006", "The result of a push is ignored",
        "The result of this push is ignored, so that a value which the queue rejects is lost unnoticed; look at it, or "
            + "write '_ =' where the queue drops by its rule",
        Category, DiagnosticSeverity.Warning, isEnabledByDefault: true, Description(6));

    public static readonly DiagnosticDescriptor LateDeclaration = new(
        "RABIT0007", "An endpoint is declared after the constructor",
        "'{0}' declares in '{1}' of manager '{2}', after the wiring, and throws; declare in the constructor",
        Category, DiagnosticSeverity.Warning, isEnabledByDefault: true, Description(7));

    public static readonly DiagnosticDescriptor LeaseUsedAfterPush = new(
        "RABIT0008", "A lease of a buffer is used after it was pushed",
        "'{0}' was pushed: the buffer has another owner, who may have returned it; use it before, or keep the result of "
            + "the push and use it only where that is Rejected",
        Category, DiagnosticSeverity.Info, isEnabledByDefault: true, Description(8));

    public static readonly DiagnosticDescriptor DefaultTimerOnly = new(
        "RABIT0009", "Only the default timer wakes a manager",
        "Nothing wakes manager '{0}' but the default timer, once a second; set WakeUpDelay or Period, or let a message "
            + "or a queue wake it",
        Category, DiagnosticSeverity.Info, isEnabledByDefault: true, Description(9));

    private static string Description(int number) => $"More in docs/analyzers/RABIT000{number}.md of Rabit.";
}
