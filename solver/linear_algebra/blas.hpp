// SPDX-License-Identifier: GPL-3.0-or-later
// The routines of BLAS and LAPACK that the factorisations call. Matrices by columns; n: not transposed, t: transposed.
#pragma once

extern "C" {
void dgemm_(const char* trans_a, const char* trans_b, const int* m, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* b, const int* ldb, const double* beta, double* c, const int* ldc);
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha, const double* a,
            const int* lda, const double* beta, double* c, const int* ldc);
void dtrsm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m, const int* n,
            const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dtrmm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m, const int* n,
            const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            const double* x, const int* incx, const double* beta, double* y, const int* incy);
void dtrmv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a, const int* lda, double* x,
            const int* incx);
void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a, const int* lda, double* x,
            const int* incx);
void dtbmv_(const char* uplo, const char* trans, const char* diag, const int* n, const int* k, const double* a, const int* lda,
            double* x, const int* incx);
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* pivots, int* info);
void dgetrs_(const char* trans, const int* n, const int* n_rhs, const double* a, const int* lda, const int* pivots, double* b,
             const int* ldb, int* info);
void dgecon_(const char* norm, const int* n, const double* a, const int* lda, const double* a_norm, double* rcond, double* work,
             int* work_of_ints, int* info);
void dpbtrf_(const char* uplo, const int* n, const int* k, double* a, const int* lda, int* info);
void dpbtrs_(const char* uplo, const int* n, const int* k, const int* n_rhs, const double* a, const int* lda, double* b,
             const int* ldb, int* info);
void dlacn2_(const int* n, double* v, double* x, int* sign, double* estimate, int* task, int* state);
}
