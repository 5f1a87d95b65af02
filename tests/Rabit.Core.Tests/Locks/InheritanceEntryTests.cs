using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Locks;
using Rabit.Core.RealTimeKit;
using Xunit;

namespace Rabit.Core.Tests.Locks;

/// <summary>How a held lock with priority inheritance is entered, for each answer of the kernel.</summary>
public sealed unsafe class InheritanceEntryTests
{
    private const int Own = 11;
    private const int Other = 22;
    private const int Waiters = int.MinValue;   // FUTEX_WAITERS

    /// <summary>
    /// EINTR is not seen from this call on kernels of today, which begin it again; their manual does not promise it.
    /// </summary>
    [Theory, Trait("Clause", "1.8")]
    [InlineData(SystemErrors.Interrupted)]
    [InlineData(SystemErrors.TryAgain)]
    [InlineData(SystemErrors.OutOfMemory)]
    public void Enter_KernelGivesATransientError_AsksAgain(int error)
    {
        Kernel kernel = Enter(Other, error, error, 0);

        Assert.Equal(3, kernel.Calls);
        Assert.Equal(Own, kernel.Word);
        Assert.Equal(0, kernel.Looks);
    }

    [Theory, Trait("Clause", "1.8")]
    [InlineData(Other)]
    [InlineData(Other | Waiters)]   // of a waiter that has ended, too
    public void Enter_HolderHasEnded_ReplacesIt(int word)
    {
        Kernel kernel = Enter(word, k => k.Alive.Clear(), SystemErrors.NoSuchProcess);

        Assert.Equal(Own, kernel.Word);
        Assert.Equal((1, 1), (kernel.Calls, kernel.Looks));
    }

    /// <summary>Between the kernel's answer and the look another thread has taken the lock over.</summary>
    [Theory, Trait("Clause", "1.8")]
    [InlineData(Other)]
    [InlineData(Other | Waiters)]
    public void Enter_HolderIsAliveAfterAll_IsNotReplaced(int word)
    {
        Kernel kernel = Enter(word, SystemErrors.NoSuchProcess, 0);

        Assert.Equal((2, 1), (kernel.Calls, kernel.Looks));
        Assert.Equal(Own, kernel.Word);
    }

    /// <summary>Two threads find the same holder ended: one replaces it.</summary>
    [Fact, Trait("Clause", "1.8")]
    public void Enter_AnotherReplacesTheEndedHolderFirst_WaitsForThat()
    {
        const int Third = 33;
        Kernel kernel = Enter(
            Other, k => k.OnLook = () => k.Word = Third, SystemErrors.NoSuchProcess, SystemErrors.Interrupted, 0);

        Assert.Equal(3, kernel.Calls);
        Assert.Equal([Other, Third, Third], kernel.WordsAtCalls);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Enter_LockIsFreeWhenLookedAt_TakesIt()
    {
        Kernel kernel = Enter(0, SystemErrors.NoSuchProcess);

        Assert.Equal((1, 0), (kernel.Calls, kernel.Looks));
        Assert.Equal(Own, kernel.Word);
    }

    [Fact]
    public void Enter_AnyOtherError_IsNamed()
    {
        var thrown = Assert.Throws<InvalidOperationException>(() => Enter(Other, SystemErrors.NotPermitted));

        Assert.Contains("EPERM", thrown.Message, StringComparison.Ordinal);
    }

    private static Kernel Enter(int word, params int[] answers) => Enter(word, _ => { }, answers);

    private static Kernel Enter(int word, Action<Kernel> prepare, params int[] answers)
    {
        var kernel = new Kernel(answers) { Word = word };
        prepare(kernel);
        Kernel.Current = kernel;
        int own = word;
        kernel.Address = new IntPtr(&own);
        try
        {
            InheritanceEntry<Calls>.Enter(&own, Own);
        }
        finally
        {
            Kernel.Current = null;
        }

        kernel.Address = IntPtr.Zero;
        kernel.Word = own;
        return kernel;
    }

    /// <summary>A kernel that gives the answers of the test, on its thread.</summary>
    private sealed class Kernel(int[] answers)
    {
        private int _word;

        [field: ThreadStatic]
        public static Kernel? Current { get; set; }

        public IntPtr Address { get; set; }

        /// <summary>Of the lock.</summary>
        public int Word
        {
            get => Address == IntPtr.Zero ? _word : *(int*)Address;
            set
            {
                if (Address == IntPtr.Zero)
                    _word = value;
                else
                    *(int*)Address = value;
            }
        }

        public HashSet<int> Alive { get; } = [Other];

        public Action? OnLook { get; set; }

        public List<int> WordsAtCalls { get; } = [];

        public int Calls => WordsAtCalls.Count;

        public int Looks { get; private set; }

        public int Lock()
        {
            int answer = answers.ElementAt(Calls);
            WordsAtCalls.Add(Word);
            if (answer == 0)
                Word = Own;
            return answer;
        }

        public bool IsAlive(int thread)
        {
            Looks++;
            bool isAlive = OnLook is null && Alive.Contains(thread);
            OnLook?.Invoke();
            return isAlive;
        }
    }

    private readonly struct Calls : IInheritanceCalls
    {
        public int Lock(int* word) => Kernel.Current!.Lock();

        public bool IsAlive(int threadId) => Kernel.Current!.IsAlive(threadId);
    }
}
