namespace Rabit.Core.Tests.Exploration;

/// <summary>A fault that is put into <see cref="FaultyLoan"/>, for the explorer to find.</summary>
public enum SeededLoanFault
{
    /// <summary>None: what is left is right.</summary>
    None,

    /// <summary>The sleeper that returns from its wait goes to work without a look whether it is lent.</summary>
    SleeperDoesNotTakeBack,

    /// <summary>It looks whether it is lent, and takes its marks away in a second step.</summary>
    TakesBackInTwoSteps,

    /// <summary>The borrower says that the sleeper sleeps on, whatever has come meanwhile.</summary>
    LoanEndsWithoutALook,

    /// <summary>The borrower leaves what has come meanwhile to the sleeper, and does not signal it.</summary>
    LoanEndsWithoutASignal,

    /// <summary>The sleeper that finds itself lent waits, and does not say so.</summary>
    SleeperWaitsUnnoticed,

    /// <summary>A loan begins whether or not the sleeper sleeps.</summary>
    BorrowsTheAwake,

    /// <summary>A borrower works on, though a stop has come.</summary>
    BorrowerIgnoresTheStop,
}
