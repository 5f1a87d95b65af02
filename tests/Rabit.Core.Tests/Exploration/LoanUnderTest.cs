using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>A sleeper that lends itself, as a model of it uses it.</summary>
internal abstract class LoanUnderTest : WakeUpUnderTest
{
    /// <summary>Begins a loan, if the sleeper sleeps.</summary>
    public abstract bool TryBorrow();

    /// <summary>What the borrower is to work on; with a stop it works on nothing.</summary>
    public abstract ConsumedWakeUps ConsumeLent();

    /// <summary>Ends the loan.</summary>
    public abstract void EndLoan(bool isToWake);
}
